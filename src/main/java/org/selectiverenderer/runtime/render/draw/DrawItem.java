package org.selectiverenderer.runtime.render.draw;

import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.instance.Surface;
import org.selectiverenderer.runtime.render.gpu.GpuMesh;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.ShapePrograms;
import org.selectiverenderer.runtime.render.light.Lighting;

/**
 * A shape instance with everything on the graphics card that drawing it takes. Valid as long as the
 * shape has this mesh and surface.
 *
 * @param source the shape's mesh; what is drawn of it may be finer
 * @param byPixel the programs that light it at its pixels
 * @param byVertex those that light it at its vertices
 * @param numbers the material as the light model wants it
 * @param blended whether it is drawn over what is behind, back to front
 * @param rank of its program and texture in the order of drawing
 */
public record DrawItem(
    ShapeInstance shape,
    Mesh source,
    Surface surface,
    GpuMesh mesh,
    @Nullable GpuTexture texture,
    ShapePrograms.Family byPixel,
    ShapePrograms.Family byVertex,
    Lighting lighting,
    float[] numbers,
    float[] textureTransform,
    boolean blended,
    int rank) {

  /** Whether the shape still has what this was made from. */
  boolean current() {
    return shape.surface() == surface && shape.mesh().orElse(null) == source;
  }

  /** The programs for an eye at a place in the world. */
  ShapePrograms.Family programs(Vector3dc eye) {
    return lighting.byVertex(shape, eye) ? byVertex : byPixel;
  }

  /** Of indices that are drawn, how many the shape's own mesh has for the same. */
  long own(long drawn) {
    int own = source.indices().length;
    return mesh.indexCount() == own ? drawn : Math.round(drawn / 3.0 * own / mesh.indexCount()) * 3;
  }
}
