// The smooth part of the field by cosine transforms, as products with dense matrices (decision 14). The paper solves a
// Poisson equation here too (section 3, Particle Systems).
#include "background/long_waves.hpp"

#include "background/forces.hpp"
#include "base/parallel.hpp"

#include <cmath>

namespace cleft
{

namespace
{

constexpr double kPi = 3.14159265358979323846;
using Matrix = LongWaves::Matrix;
using Cells = LongWaves::Cells;

int64_t cell_count(const Cells& cells) { return int64_t{cells[0]} * cells[1] * cells[2]; }

// Quadratic B-spline around the cell of x on one axis, mirrored at the walls: three cells, weights and slopes.
// Quadratic, since the force is a derivative of it: that of a linear one would jump between cells.
struct Spline {
    FixedArray<int32_t, 3> cell;
    FixedArray<float, 3> weight, slope;
};

Spline spline(double x, double length, int32_t cells)
{
    const double per_length = cells / length, u = x * per_length;
    const int32_t middle = std::clamp(static_cast<int32_t>(u), 0, cells - 1);
    const auto d = static_cast<float>(u - middle - 0.5), p = static_cast<float>(per_length);
    Spline s;
    s.cell = {std::max(middle - 1, 0), middle, std::min(middle + 1, cells - 1)};
    s.weight = {0.5F * (0.5F - d) * (0.5F - d), 0.75F - d * d, 0.5F * (0.5F + d) * (0.5F + d)};
    s.slope = {(d - 0.5F) * p, -2 * d * p, (d + 0.5F) * p};
    return s;
}

FixedArray<Spline, 3> splines(const Vec3& x, const Vec3& extent, const Cells& cells)
{
    return {spline(x[0], extent[0], cells[0]), spline(x[1], extent[1], cells[1]), spline(x[2], extent[2], cells[2])};
}

void deposit(const Vec3& x, float charge, const Vec3& extent, const Cells& cells, float* grid)
{
    const auto s = splines(x, extent, cells);
    for (size_t k = 0; k < 3; ++k)
        for (size_t j = 0; j < 3; ++j) {
            float* row = grid + int64_t{cells[0]} * (s[1].cell[j] + int64_t{cells[1]} * s[2].cell[k]);
            const float w = charge * s[1].weight[j] * s[2].weight[k];
            for (size_t i = 0; i < 3; ++i)
                row[s[0].cell[i]] += w * s[0].weight[i];
        }
}

// Few chunks of particles, each with a grid of its own; the grids are added up in their order.
// Their number follows from that of the particles, so that sums of floats are the same for any number of threads.
Array<float> particle_charge(const LongWaves& waves, const ParticleSet& particles, const Run& run)
{
    // 16 grids of 80^3 cells take 33 MB. For fewer particles than these, a grid of their own costs more than it saves.
    constexpr int64_t kMostGrids = 16, kLeastParticles = 4096;
    const Cells& cells = waves.levels[0].cells;
    const auto n = particles.count();
    const int64_t grain = std::max(kLeastParticles, chunk_count(n, kMostGrids));
    Array<Array<float>> grids(chunk_count(n, grain));
    parallel_chunks(run, n, grain, [&](int64_t chunk, int64_t begin, int64_t end) {
        auto& grid = grids[chunk];
        grid.assign(cell_count(cells), 0);
        for (int64_t i = begin; i < end; ++i)
            deposit(particles.x[i], static_cast<float>(share_of_box(particles.walls[i])), waves.extent, cells,
                    grid.data());
    });
    for (size_t g = 1; g < grids.size(); ++g)
        for (size_t c = 0; c < grids[0].size(); ++c)
            grids[0][c] += grids[g][c];
    return std::move(grids[0]);
}

// The integral of h^-3 over a brick: Gauss's rule on parts small enough.
// The value at the centre alone can miss most of the charge where h changes within a cell.
double integral(const SizeSampler& size, const Vec3& centre, const Vec3& sides)
{
    const double widest = sides.maxCoeff(), h = static_cast<double>(size(centre));
    if (widest <= 0.25 * h)
        return sides.prod() / (h * h * h);
    const bool divide = widest > h;
    const double offset = divide ? 0.25 : 0.5 / std::sqrt(3.0);
    double sum = 0;
    for (int part = 0; part < 8; ++part) {
        const Vec3 sign(part & 1 ? 1 : -1, part & 2 ? 1 : -1, part & 4 ? 1 : -1);
        const Vec3 x = centre + offset * sign.cwiseProduct(sides);
        const double hx = static_cast<double>(size(x));
        sum += divide ? integral(size, x, sides / 2) : sides.prod() / 8 / (hx * hx * hx);
    }
    return sum;
}

Array<float> background_charge(const SizeSampler& size, const Cells& cells, const Run& run)
{
    Array<float> charge(cell_count(cells));
    const Vec3 sides = size.extent().cwiseQuotient(Vec3(cells[0], cells[1], cells[2]));
    parallel_for(run, charge.count(), 64, [&](int64_t begin, int64_t end) {
        for (int64_t c = begin; c < end; ++c) {
            const Vec3 place(static_cast<double>(c % cells[0]), static_cast<double>(c / cells[0] % cells[1]),
                             static_cast<double>(c / cells[0] / cells[1]));
            const Vec3 centre = (place.array() + 0.5).matrix().cwiseProduct(sides);
            charge[c] = static_cast<float>(kParticleDensity[3] * integral(size, centre, sides));
        }
    });
    return charge;
}

double sinc(double x) { return std::abs(x) < 1e-8 ? 1 : std::sin(x) / x; }

// cos(k x) at the cell centres by wave number and cell, divided by the transform of what a charge is spread over: a
// power of the cell.
// Spreading and reading each blur the waves. The division takes the blur back, so that the grid need not be finer.
Matrix cosines(int32_t waves, int32_t cells, int power)
{
    Matrix m(waves, cells);
    for (int32_t k = 0; k < waves; ++k)
        for (int32_t i = 0; i < cells; ++i)
            m(k, i) = static_cast<float>(std::cos(kPi * k * (i + 0.5) / cells) /
                                         std::pow(sinc(0.5 * kPi * k / cells), power));
    return m;
}

// The product of the three matrices, one for each axis, with the numbers of a grid of `from` points; `to` points come
// out.
Array<float> transformed(const FixedArray<Matrix, 3>& m, const Array<float>& in, const Run& run)
{
    const Eigen::Index nx = m[0].cols(), ny = m[1].cols(), nz = m[2].cols(), plane = m[0].rows() * m[1].rows();
    Array<float> planes(plane * nz), out(plane * m[2].rows());
    parallel_for(run, nz, 4, [&](int64_t begin, int64_t end) {
        for (int64_t z = begin; z < end; ++z) {
            const Eigen::Map<const Matrix> slice(in.data() + z * nx * ny, ny, nx);
            Eigen::Map<Matrix> result(planes.data() + z * plane, m[1].rows(), m[0].rows());
            result.noalias() = m[1] * (slice * m[0].transpose()).eval();
        }
    });
    const Eigen::Map<const Matrix> columns(planes.data(), nz, plane);
    Eigen::Map<Matrix> result(out.data(), m[2].rows(), plane);
    parallel_for(run, plane, 256, [&](int64_t begin, int64_t end) {
        result.middleCols(begin, end - begin).noalias() = m[2] * columns.middleCols(begin, end - begin);
    });
    return out;
}

// The part of the spectrum of the charge that a level can carry, as the spectrum of its potential.
Array<float> potential_waves(const LongWaves& waves, const LongWaves::Level& level, const Array<float>& charge)
{
    const Cells &all = waves.levels[0].cells, &n = level.cells;
    Array<float> out(cell_count(n), 0);
    const Vec3 base = kPi * waves.extent.cwiseInverse();
    const double scale = 4 * kPi / waves.extent.prod();
    size_t at = 0;
    for (int32_t z = 0; z < n[2]; ++z)
        for (int32_t y = 0; y < n[1]; ++y)
            for (int32_t x = 0; x < n[0]; ++x, ++at) {
                const double k2 = base.cwiseProduct(Vec3(x, y, z)).squaredNorm();
                const double phase = 0.5 * std::sqrt(k2) * level.reach;
                if (k2 == 0 || phase > kPi)
                    continue;  // beyond its first zero the transform of a cloud is next to nothing
                const int twice = (x > 0) + (y > 0) + (z > 0);
                const double cloud = sinc(phase) * sinc(phase);
                const int64_t from = x + int64_t{all[0]} * (y + int64_t{all[1]} * z);
                out[at] = static_cast<float>((1 << twice) * scale * cloud / k2) * charge[from];
            }
    return out;
}

// The least reach: that of the smallest particles, but not so small that the grid costs more than the particles.
double finest_reach(const Vec3& extent, double smallest, double particles)
{
    // The work grows with its fourth power (decision 14).
    constexpr int32_t kMostCells = 80;  // along an axis
    // A finer grid would cost more than the near forces of its particles.
    constexpr double kCellsPerParticle = 2;
    const double most = std::clamp(kCellsPerParticle * particles, 512.0, std::pow(kMostCells, 3));
    double reach = smallest;
    const auto cells = [&](int axis) { return std::max(1.0, std::ceil(2 * extent[axis] / reach)); };
    while (cells(0) * cells(1) * cells(2) > most || std::max({cells(0), cells(1), cells(2)}) > kMostCells)
        // Steps small enough that the grid comes out within a sixth of the bound.
        reach *= 1.05;
    return reach;
}

Array<LongWaves::Level> make_levels(const Vec3& extent, double finest, double largest)
{
    Array<LongWaves::Level> levels;
    for (double reach = finest;; reach *= 2) {
        LongWaves::Level level;
        level.reach = reach;
        for (int a = 0; a < 3; ++a) {
            level.cells[a] = std::max(1, static_cast<int32_t>(std::ceil(2 * extent[a] / reach)));
            // The power 3 is that of a quadratic spline, whose transform is the cube of that of a cell.
            level.from_waves[a] = cosines(level.cells[a], level.cells[a], 3).transpose();
        }
        if (cell_count(level.cells) == 1)
            return levels;
        levels.push_back(std::move(level));
        if (reach >= largest)
            return levels;
    }
}

Vec3 field_of(const LongWaves::Level& level, const Vec3& x, const Vec3& extent)
{
    const auto s = splines(x, extent, level.cells);
    Eigen::Vector3f gradient = Eigen::Vector3f::Zero();
    for (size_t k = 0; k < 3; ++k)
        for (size_t j = 0; j < 3; ++j) {
            const float* row = level.potential.data() +
                               int64_t{level.cells[0]} * (s[1].cell[j] + int64_t{level.cells[1]} * s[2].cell[k]);
            float value = 0, slope = 0;
            for (size_t i = 0; i < 3; ++i) {
                value += s[0].weight[i] * row[s[0].cell[i]];
                slope += s[0].slope[i] * row[s[0].cell[i]];
            }
            gradient += Eigen::Vector3f(slope * s[1].weight[j] * s[2].weight[k], value * s[1].slope[j] * s[2].weight[k],
                                        value * s[1].weight[j] * s[2].slope[k]);
        }
    return -gradient.cast<double>();
}

double brick_error(const Cells& cells, const Array<float>& particles, const Array<float>& charge)
{
    // Single cells hold half a particle or so. A brick of 64 holds enough of them to show a density.
    constexpr int32_t kSide = 4;
    const Cells bricks{(cells[0] + kSide - 1) / kSide, (cells[1] + kSide - 1) / kSide, (cells[2] + kSide - 1) / kSide};
    Array<double> excess(cell_count(bricks), 0), all(excess.size(), 0);
    size_t at = 0;
    for (int32_t z = 0; z < cells[2]; ++z)
        for (int32_t y = 0; y < cells[1]; ++y)
            for (int32_t x = 0; x < cells[0]; ++x, ++at) {
                const int64_t b = x / kSide + int64_t{bricks[0]} * (y / kSide + int64_t{bricks[1]} * (z / kSide));
                excess[b] += static_cast<double>(particles[at] - charge[at]);
                all[b] += static_cast<double>(charge[at]);
            }
    double error = 0, norm = 0;
    for (size_t b = 0; b < all.size(); ++b) {
        error += excess[b] * excess[b];
        norm += all[b] * all[b];
    }
    return std::sqrt(error / norm);
}

// A box whose charges do not add up to nothing has a wave of number 0, which no force can level: the surplus would
// spread evenly over the box and flood or drain the places of large h, which hold few particles. So the background
// gets the charge of the particles, each place in proportion to what it has.
void make_neutral(const ParticleSet& particles, Array<float>& background)
{
    double all = 0, wanted = 0;
    for (const Walls walls : particles.walls)
        wanted += share_of_box(walls);
    for (const float charge : background)
        all += static_cast<double>(charge);
    for (float& charge : background)
        charge = static_cast<float>(static_cast<double>(charge) * (wanted / all));
}

}  // namespace

LongWaves make_long_waves(const SizeSampler& size, double least_size, double greatest_size,
                          const ParticleSet& particles, const Run& run)
{
    LongWaves waves;
    waves.extent = size.extent();
    const double finest = finest_reach(waves.extent, kReach * least_size, static_cast<double>(particles.size()));
    waves.levels = make_levels(waves.extent, finest, kReach * greatest_size);
    if (waves.levels.empty())
        return waves;
    const Cells& cells = waves.levels[0].cells;
    waves.background = background_charge(size, cells, run);
    make_neutral(particles, waves.background);
    FixedArray<Matrix, 3> from_cells;
    for (int a = 0; a < 3; ++a) {
        waves.to_waves[a] = cosines(cells[a], cells[a], 3);
        // The background is given as means over cells: power 1.
        from_cells[a] = cosines(cells[a], cells[a], 1);
    }
    waves.background_waves = transformed(from_cells, waves.background, run);
    return waves;
}

double solve_poisson(LongWaves& waves, const ParticleSet& particles, const Run& run)
{
    if (waves.levels.empty())
        return 0;
    const Array<float> charge = particle_charge(waves, particles, run);
    Array<float> spectrum = transformed(waves.to_waves, charge, run);
    for (size_t k = 0; k < spectrum.size(); ++k)
        spectrum[k] -= waves.background_waves[k];
    for (LongWaves::Level& level : waves.levels)
        level.potential = transformed(level.from_waves, potential_waves(waves, level, spectrum), run);
    return brick_error(waves.levels[0].cells, charge, waves.background);
}

// Between two levels the second moment of the cloud is kept.
// A particle's reach seldom is that of a level. The mixture then is as wide as the cloud of the particle's own reach.
Vec3 field_at(const LongWaves& waves, const Vec3& x, double reach)
{
    if (waves.levels.empty())
        return Vec3::Zero();
    size_t l = 0;
    while (l + 1 < waves.levels.size() && waves.levels[l + 1].reach <= reach)
        ++l;
    Vec3 field = field_of(waves.levels[l], x, waves.extent);
    if (l + 1 < waves.levels.size() && reach > waves.levels[l].reach) {
        const double low = waves.levels[l].reach, high = waves.levels[l + 1].reach;
        const double share = (reach * reach - low * low) / (high * high - low * low);
        field = (1 - share) * field + share * field_of(waves.levels[l + 1], x, waves.extent);
    }
    return field;
}

}  // namespace cleft
