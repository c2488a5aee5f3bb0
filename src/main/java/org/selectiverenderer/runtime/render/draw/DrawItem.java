package org.selectiverenderer.runtime.render.draw;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.instance.Surface;
import org.selectiverenderer.runtime.render.gpu.GpuMesh;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.ShapePrograms;

/**
 * A shape instance with everything on the graphics card that drawing it takes. Valid as long as the
 * shape has this mesh and surface.
 *
 * @param lights those whose scope it lies in; equal lists are the same object
 * @param numbers the material as the fragment shader wants it
 * @param blended whether it is drawn over what is behind, back to front
 * @param rank of its program and texture in the order of drawing
 */
public record DrawItem(
    ShapeInstance shape,
    Mesh source,
    Surface surface,
    GpuMesh mesh,
    @Nullable GpuTexture texture,
    ShapePrograms.Family programs,
    List<LightInstance> lights,
    float[] numbers,
    float[] textureTransform,
    boolean blended,
    int rank) {

  /** Whether every pixel of it covers what is behind. */
  boolean opaque() {
    return !blended && (texture == null || texture.alpha() == GpuTexture.Alpha.NONE);
  }

  /** Whether the shape still has what this was made from. */
  boolean current() {
    return shape.surface() == surface && shape.mesh().orElse(null) == source;
  }
}
