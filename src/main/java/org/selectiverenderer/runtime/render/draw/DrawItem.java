package org.selectiverenderer.runtime.render.draw;

import java.util.List;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.instance.Surface;
import org.selectiverenderer.runtime.render.gpu.GpuMesh;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.ShapePrograms;
import org.selectiverenderer.runtime.render.mesh.Clusters;

/**
 * A shape instance with everything on the graphics card that drawing it takes. Valid as long as the
 * shape has this mesh and surface and, in a batch, stands where it stood.
 *
 * @param part what it draws
 * @param lights those whose scope it lies in; equal lists are the same object
 * @param numbers the material as the fragment shader wants it
 * @param blended whether it is drawn over what is behind, back to front
 * @param rank of its program and texture in the order of drawing
 */
public record DrawItem(
    ShapeInstance shape,
    Mesh source,
    Surface surface,
    MeshPart part,
    @Nullable GpuTexture texture,
    ShapePrograms.Family programs,
    List<LightInstance> lights,
    float[] numbers,
    float[] textureTransform,
    boolean blended,
    int rank) {

  /** The buffers, which other items may share. */
  public GpuMesh mesh() {
    return part.mesh();
  }

  /** Whether every pixel of it covers what is behind. */
  boolean opaque() {
    return !blended && (texture == null || texture.alpha() == GpuTexture.Alpha.NONE);
  }

  /** Which triangles of the buffers are its own. */
  public Clusters clusters() {
    return part.clusters();
  }

  /** From the coordinates of the buffers to the world. */
  public Matrix4dc place() {
    return part.place(shape);
  }

  /** Whether the shape still has what this was made from. */
  boolean current() {
    return shape.surface() == surface && shape.mesh().orElse(null) == source && part.holds(shape);
  }
}
