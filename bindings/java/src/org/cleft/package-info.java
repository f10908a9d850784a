/**
 * Conforming multi-material tetrahedral meshes from labelled volumes, by mesh cleaving.
 *
 * <p>A {@link org.cleft.Mesher} makes everything else: volumes from arrays, sizing fields, meshes.
 * {@link org.cleft.MeshFiles} reads and writes files. All that owns native memory is {@link java.lang.AutoCloseable};
 * what is not closed is freed when it is no longer reachable.
 */
package org.cleft;
