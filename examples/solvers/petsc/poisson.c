/* PETSc on a mesh in parts: the potential about a ball that conducts better, against the exact solution.
 *
 * Each rank gives its part to a DMPlex in memory: DMPlex wants the points numbered as those of parts are. Nothing is
 * gathered, and no file is written. Elements are linear, and conjugate gradients with algebraic
 * multigrid solve the system. The program halves the edge length, and fails if the error does not fall by its square.
 *
 *     mpicc poisson.c $(pkg-config --cflags --libs cleft-mpi petsc) -lm -o poisson && mpirun -n 4 ./poisson
 */
#include "../ball_in_field.h"

#include <petscdmplex.h>
#include <petscds.h>
#include <petscsf.h>
#include <petscsnes.h>

/* ---------------------------------------------------------------------------------------------------- the mesh -- */

/* Faces with one cell lie on the hull, unless another rank has the face too. DMPlexMarkBoundaryFaces() alone does not
 * ask the other ranks. */
static PetscErrorCode mark_hull(DM dm)
{
    PetscSF shared;
    DMLabel hull;
    PetscInt begin, end, leaves;
    const PetscInt *degree, *leaf;
    PetscMPIInt ranks;
    PetscFunctionBeginUser;
    PetscCall(DMCreateLabel(dm, "hull"));
    PetscCall(DMGetLabel(dm, "hull", &hull));
    PetscCall(DMPlexMarkBoundaryFaces(dm, 1, hull));
    PetscCallMPI(MPI_Comm_size(PETSC_COMM_WORLD, &ranks));
    if (ranks > 1) {
        PetscCall(DMPlexGetHeightStratum(dm, 1, &begin, &end));
        PetscCall(DMGetPointSF(dm, &shared));
        PetscCall(PetscSFComputeDegreeBegin(shared, &degree));
        PetscCall(PetscSFComputeDegreeEnd(shared, &degree));
        for (PetscInt f = begin; f < end; ++f)
            if (degree[f] > 0)
                PetscCall(DMLabelClearValue(hull, f, 1));
        PetscCall(PetscSFGetGraph(shared, NULL, &leaves, &leaf, NULL));
        for (PetscInt i = 0; i < leaves; ++i)
            if (begin <= leaf[i] && leaf[i] < end)
                PetscCall(DMLabelClearValue(hull, leaf[i], 1));
    }
    PetscCall(DMPlexLabelComplete(dm, hull)); /* their edges and points, on all ranks that have these */
    PetscFunctionReturn(0);
}

/* The points that a rank owns follow one another, those of rank 0 first: the numbering of DMPlex. */
static PetscErrorCode make_plex(const cleft_part* part, DM* dm)
{
    const int64_t* numbers = cleft_part_point_numbers(part);
    const int32_t* tets = cleft_part_tets(part);
    cleft_part_counts n = {.struct_size = sizeof n};
    PetscInt *corners, owned_points, owned_tets, all_points;
    DMLabel material;
    PetscFunctionBeginUser;
    PetscCheck(cleft_part_count(part, &n) == CLEFT_OK, PETSC_COMM_SELF, PETSC_ERR_LIB, "cleft_part_count");
    PetscCall(PetscIntCast(n.owned_points, &owned_points));
    PetscCall(PetscIntCast(n.owned_tets, &owned_tets));
    PetscCall(PetscIntCast(n.all_points, &all_points));
    PetscCall(PetscMalloc1(4 * n.owned_tets, &corners));
    /* DMPlex calls those tetrahedra positive that Cleft and most others call negative. */
    for (int64_t i = 0; i < 4 * n.owned_tets; ++i)
        corners[i] = (PetscInt)numbers[tets[i % 4 < 2 ? i ^ 1 : i]];
    PetscCall(DMPlexCreateFromCellListParallelPetsc(PETSC_COMM_WORLD, 3, owned_tets, owned_points, all_points, 4,
                                                    PETSC_TRUE, corners, 3, cleft_part_points(part), NULL, NULL, dm));
    PetscCall(PetscFree(corners));

    /* Cells keep their order. PETSc's own readers of files name the label so, too. */
    PetscCall(DMCreateLabel(*dm, "Cell Sets"));
    PetscCall(DMGetLabel(*dm, "Cell Sets", &material));
    for (PetscInt c = 0; c < owned_tets; ++c)
        PetscCall(DMLabelSetValue(material, c, cleft_part_tet_labels(part)[c]));
    PetscCall(mark_hull(*dm));
    PetscFunctionReturn(0);
}

/* The volume of each label as DMPlex has it, which must be that of the part. */
static PetscErrorCode check_volumes(DM dm, const double* expected)
{
    PetscReal mine[BALL_LABELS + 1] = {0}, all[BALL_LABELS + 1], volume;
    PetscInt begin, end, label;
    PetscFunctionBeginUser;
    PetscCall(DMPlexGetHeightStratum(dm, 0, &begin, &end));
    for (PetscInt c = begin; c < end; ++c) {
        PetscCall(DMPlexComputeCellGeometryFVM(dm, c, &volume, NULL, NULL));
        PetscCall(DMGetLabelValue(dm, "Cell Sets", c, &label));
        mine[label] += volume;
    }
    PetscCallMPI(MPI_Allreduce(mine, all, BALL_LABELS + 1, MPIU_REAL, MPIU_SUM, PETSC_COMM_WORLD));
    for (label = 1; label <= BALL_LABELS; ++label) {
        PetscCall(PetscPrintf(PETSC_COMM_WORLD, "label %d: volume %.9f\n", (int)label, (double)all[label]));
        PetscCheck(PetscAbsReal(all[label] - expected[label]) < 1e-12, PETSC_COMM_WORLD, PETSC_ERR_PLIB,
                   "label %d has the volume %.15f in Cleft", (int)label, expected[label]);
    }
    PetscFunctionReturn(0);
}

/* ------------------------------------------------------------------------------------------------ the equation -- */

/* The arguments are those that PETSc asks for: u_x is the gradient, a[0] the conductivity of the cell. */
static void flux(PetscInt dim, PetscInt fields, PetscInt aux_fields, const PetscInt u_offset[],
                 const PetscInt u_x_offset[], const PetscScalar u[], const PetscScalar u_t[], const PetscScalar u_x[],
                 const PetscInt a_offset[], const PetscInt a_x_offset[], const PetscScalar a[], const PetscScalar a_t[],
                 const PetscScalar a_x[], PetscReal t, const PetscReal x[], PetscInt constants,
                 const PetscScalar constant[], PetscScalar f1[])
{
    for (PetscInt d = 0; d < dim; ++d)
        f1[d] = a[0] * u_x[d];
}

static void flux_derivative(PetscInt dim, PetscInt fields, PetscInt aux_fields, const PetscInt u_offset[],
                            const PetscInt u_x_offset[], const PetscScalar u[], const PetscScalar u_t[],
                            const PetscScalar u_x[], const PetscInt a_offset[], const PetscInt a_x_offset[],
                            const PetscScalar a[], const PetscScalar a_t[], const PetscScalar a_x[], PetscReal t,
                            PetscReal u_t_shift, const PetscReal x[], PetscInt constants, const PetscScalar constant[],
                            PetscScalar g3[])
{
    for (PetscInt d = 0; d < dim; ++d)
        g3[d * dim + d] = a[0];
}

static PetscErrorCode exact(PetscInt dim, PetscReal t, const PetscReal x[], PetscInt components, PetscScalar* u,
                            void* user)
{
    u[0] = ball_exact(x);
    return 0;
}

/* A number for each cell: its conductivity. */
static PetscErrorCode set_conductivity(DM dm, PetscFE element)
{
    DM cells;
    PetscFE constant;
    Vec values;
    PetscScalar *array, *value;
    PetscInt begin, end, label;
    PetscFunctionBeginUser;
    PetscCall(DMClone(dm, &cells));
    PetscCall(PetscFECreateLagrange(PETSC_COMM_SELF, 3, 1, PETSC_TRUE, 0, PETSC_DETERMINE, &constant));
    PetscCall(PetscFECopyQuadrature(element, constant));
    PetscCall(DMSetField(cells, 0, NULL, (PetscObject)constant));
    PetscCall(DMCreateDS(cells));
    PetscCall(DMCreateLocalVector(cells, &values));
    PetscCall(VecGetArray(values, &array));
    PetscCall(DMPlexGetHeightStratum(dm, 0, &begin, &end));
    for (PetscInt c = begin; c < end; ++c) {
        PetscCall(DMGetLabelValue(dm, "Cell Sets", c, &label));
        PetscCall(DMPlexPointLocalRef(cells, c, array, &value));
        *value = ball_conductivity((int)label);
    }
    PetscCall(VecRestoreArray(values, &array));
    PetscCall(DMSetAuxiliaryVec(dm, NULL, 0, 0, values));
    PetscCall(VecDestroy(&values));
    PetscCall(PetscFEDestroy(&constant));
    PetscCall(DMDestroy(&cells));
    PetscFunctionReturn(0);
}

static PetscErrorCode set_equation(DM dm)
{
    const PetscInt one = 1;
    PetscFE element;
    PetscDS equation;
    DMLabel hull;
    PetscFunctionBeginUser;
    PetscCall(PetscFECreateLagrange(PETSC_COMM_SELF, 3, 1, PETSC_TRUE, 1, 4, &element));
    PetscCall(DMSetField(dm, 0, NULL, (PetscObject)element));
    PetscCall(DMCreateDS(dm));
    PetscCall(DMGetDS(dm, &equation));
    PetscCall(PetscDSSetResidual(equation, 0, NULL, flux));
    PetscCall(PetscDSSetJacobian(equation, 0, 0, NULL, NULL, NULL, flux_derivative));
    PetscCall(DMGetLabel(dm, "hull", &hull));
    PetscCall(
        DMAddBoundary(dm, DM_BC_ESSENTIAL, "hull", hull, 1, &one, 0, 0, NULL, (void (*)(void))exact, NULL, NULL, NULL));
    PetscCall(set_conductivity(dm, element));
    PetscCall(PetscFEDestroy(&element));
    PetscFunctionReturn(0);
}

/* Solves, and gives the error in the L2 norm. The equation is linear, so a SNES of one step is a KSP. */
static PetscErrorCode solve(DM dm, PetscReal* error)
{
    PetscErrorCode (*truth[1])(PetscInt, PetscReal, const PetscReal[], PetscInt, PetscScalar*, void*) = {exact};
    SNES snes;
    KSP ksp;
    PC pc;
    Vec u;
    PetscInt steps;
    KSPConvergedReason reason;
    PetscFunctionBeginUser;
    PetscCall(DMPlexSetSNESLocalFEM(dm, NULL, NULL, NULL));
    PetscCall(DMCreateGlobalVector(dm, &u));
    PetscCall(SNESCreate(PETSC_COMM_WORLD, &snes));
    PetscCall(SNESSetDM(snes, dm));
    PetscCall(SNESSetType(snes, SNESKSPONLY));
    PetscCall(SNESGetKSP(snes, &ksp));
    PetscCall(KSPSetType(ksp, KSPCG));
    PetscCall(KSPSetTolerances(ksp, 1e-10, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT));
    PetscCall(KSPGetPC(ksp, &pc));
    PetscCall(PCSetType(pc, PCGAMG));
    PetscCall(SNESSetFromOptions(snes));
    PetscCall(SNESSolve(snes, NULL, u));
    PetscCall(KSPGetConvergedReason(ksp, &reason));
    PetscCall(KSPGetIterationNumber(ksp, &steps));
    PetscCheck(reason > 0, PETSC_COMM_WORLD, PETSC_ERR_CONV_FAILED, "the solver ends with reason %d", (int)reason);
    PetscCall(DMComputeL2Diff(dm, 0, truth, NULL, u, error));
    PetscCall(PetscPrintf(PETSC_COMM_WORLD, "%d steps, error %.9f\n", (int)steps, (double)*error));
    PetscCall(SNESDestroy(&snes));
    PetscCall(VecDestroy(&u));
    PetscFunctionReturn(0);
}

static PetscErrorCode error_of_size(double size, PetscReal* error)
{
    double volumes[BALL_LABELS + 1];
    cleft_part* part = ball_part(PETSC_COMM_WORLD, size, 0);
    DM dm;
    PetscFunctionBeginUser;
    PetscCheck(part, PETSC_COMM_WORLD, PETSC_ERR_LIB, "there is no mesh");
    ball_volumes(PETSC_COMM_WORLD, part, volumes);
    PetscCall(make_plex(part, &dm));
    cleft_part_destroy(part);
    PetscCall(check_volumes(dm, volumes));
    PetscCall(set_equation(dm));
    PetscCall(solve(dm, error));
    PetscCall(DMDestroy(&dm));
    PetscFunctionReturn(0);
}

int main(int argc, char** argv)
{
    PetscReal coarse, fine;
    PetscCall(PetscInitialize(&argc, &argv, NULL, NULL));
    PetscCall(error_of_size(0.24, &coarse));
    PetscCall(error_of_size(0.12, &fine));
    PetscCall(PetscPrintf(PETSC_COMM_WORLD, "half the edges, and the error falls to %.2f\n", (double)(fine / coarse)));
    PetscCheck(fine < 0.3 * coarse && fine < 0.005, PETSC_COMM_WORLD, PETSC_ERR_PLIB, "the error is too great");
    return PetscFinalize();
}
