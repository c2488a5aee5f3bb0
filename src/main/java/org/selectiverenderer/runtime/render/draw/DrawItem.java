package org.selectiverenderer.runtime.render.draw;

import java.util.List;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.instance.Stroke;
import org.selectiverenderer.runtime.instance.Surface;
import org.selectiverenderer.runtime.instance.Surroundings;
import org.selectiverenderer.runtime.render.gpu.DetailTextures;
import org.selectiverenderer.runtime.render.gpu.GpuMesh;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.ShapeProgram;
import org.selectiverenderer.runtime.render.gpu.ShapePrograms;
import org.selectiverenderer.runtime.render.gpu.StrokeForm;
import org.selectiverenderer.runtime.render.light.Lighting;
import org.selectiverenderer.runtime.render.mesh.Clusters;

/**
 * A shape instance with everything on the graphics card that drawing it takes. Valid as long as the
 * shape has this mesh and surface and, in a batch, stands where it stood.
 *
 * @param source the shape's mesh; what is drawn of it may be finer
 * @param part what it draws
 * @param byPixel the programs that light it at its pixels
 * @param byVertex those that light it at its vertices
 * @param numbers the material as the light model wants it
 * @param blended whether it is drawn over what is behind, back to front
 * @param form how its primitives become pixels
 * @param around the fog and planes whose scope it is in
 * @param rank of its program and texture in the order of drawing
 * @param detail of a surface that has more than a material and an image, else null
 * @param author what the program of an author makes of it, in place of all that; else null
 */
public record DrawItem(
    ShapeInstance shape,
    Mesh source,
    Surface surface,
    MeshPart part,
    @Nullable GpuTexture texture,
    ShapePrograms.Family byPixel,
    ShapePrograms.Family byVertex,
    Lighting lighting,
    float[] numbers,
    float[] textureTransform,
    boolean blended,
    StrokeForm form,
    Stroke stroke,
    Surroundings around,
    int rank,
    @Nullable DetailTextures detail,
    @Nullable AuthorLook author) {

  /** The buffers, which other items may share. */
  public GpuMesh mesh() {
    return part.mesh();
  }

  /** Whether every pixel of it covers what is behind. */
  boolean opaque() {
    return !blended
        && author == null
        && !stroke.hollow()
        && around.planes().isEmpty()
        && (texture == null || texture.alpha() == GpuTexture.Alpha.NONE)
        && (detail == null || !detail.holes());
  }

  /** Whether nobody knows where it will be seen. */
  boolean anywhere() {
    return author != null && author.moves();
  }

  /** Which triangles of the buffers are its own, as finely as they are divided. */
  public Clusters clusters() {
    return part.clusters();
  }

  /** From the coordinates of the buffers to the world. */
  public Matrix4dc place() {
    return part.place(shape);
  }

  /** Whether the shape still has what this was made from. */
  boolean current() {
    return shape.surface() == surface
        && shape.mesh().orElse(null) == source
        && shape.stroke() == stroke
        && part.holds(shape);
  }

  /** The programs for where the shape is now. */
  ShapePrograms.Family programs() {
    return lighting.byVertex(shape) ? byVertex : byPixel;
  }

  /** The lights that may reach it where it is now. */
  List<LightInstance> reaching() {
    return lighting.reaching(shape, ShapeProgram.MAX_LIGHTS - 1); // One for the headlight.
  }

  /**
   * Of indices that are drawn, how many the shape's own mesh has for the same.
   *
   * @param all that its stage has
   */
  long own(long drawn, int all) {
    int own = source.indices().length;
    return all == own ? drawn : Math.round(drawn / 3.0 * own / all) * 3;
  }
}
