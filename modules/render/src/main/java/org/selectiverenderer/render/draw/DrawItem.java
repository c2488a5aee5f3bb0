package org.selectiverenderer.render.draw;

import java.util.List;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.DrawProperties;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ScopedEffects;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.gpu.GpuMesh;
import org.selectiverenderer.render.gpu.GpuTexture;
import org.selectiverenderer.render.gpu.MaterialBinding;
import org.selectiverenderer.render.gpu.ShapeProgram;
import org.selectiverenderer.render.gpu.ShapeProgramCache;
import org.selectiverenderer.render.gpu.StrokeStyle;
import org.selectiverenderer.render.lighting.ShapeLighting;
import org.selectiverenderer.render.mesh.TriangleClusters;

/**
 * A shape instance with everything on the graphics card that drawing it needs. It is valid as long
 * as the shape keeps this mesh and surface and, in a batch, its place.
 *
 * @param source the shape's own mesh; the mesh that is drawn may be a refined one
 * @param part the range of an index buffer that it draws
 * @param byPixel the shader programs with per-pixel lighting
 * @param byVertex the shader programs with per-vertex lighting
 * @param numbers the material's uniform values, in the order of the lighting shader
 * @param blended whether it is blended, and so drawn back to front after the opaque items
 * @param form how its lines, points or areas are rasterised
 * @param around the fog, clip planes and environment light in whose scope it is
 * @param rank the place of its program and texture in the drawing order
 * @param detail the textures and uniforms of a surface that has more than a material and one image,
 *     else null
 * @param author the custom shader that replaces material and textures, else null
 */
public record DrawItem(
    ShapeInstance shape,
    Mesh source,
    SurfaceMaterial surface,
    SubMesh part,
    @Nullable GpuTexture texture,
    ShapeProgramCache.Family byPixel,
    ShapeProgramCache.Family byVertex,
    ShapeLighting lighting,
    float[] numbers,
    float[] textureTransform,
    boolean blended,
    StrokeStyle form,
    DrawProperties stroke,
    ScopedEffects around,
    int rank,
    @Nullable MaterialBinding detail,
    @Nullable CustomShaderBinding author) {

  /** Returns the vertex and index buffer, which other items may share. */
  public GpuMesh mesh() {
    return part.mesh();
  }

  /** Returns whether every pixel of it covers what is behind it. */
  boolean opaque() {
    return !blended
        && author == null
        && !stroke.hollow()
        && around.planes().isEmpty()
        && (texture == null || texture.alpha() == GpuTexture.Alpha.NONE)
        && (detail == null || !detail.holes());
  }

  /**
   * Returns whether a custom shader may move it out of its bounds, so that it must not be culled.
   */
  boolean anywhere() {
    return author != null && author.moves();
  }

  /** Returns the clusters of its triangles at the finest refinement level. */
  public TriangleClusters clusters() {
    return part.clusters();
  }

  /** Returns the matrix from the coordinates in the buffers to the world. */
  public Matrix4dc place() {
    return part.place(shape);
  }

  /**
   * Returns whether the shape still has the mesh, surface and stroke that this item was made from.
   */
  boolean current() {
    return shape.surface() == surface
        && shape.mesh().orElse(null) == source
        && shape.stroke() == stroke
        && part.holds(shape);
  }

  /**
   * Returns the programs for the shape's present place: per vertex where that is good enough there.
   */
  ShapeProgramCache.Family programs() {
    return lighting.byVertex(shape) ? byVertex : byPixel;
  }

  /** Returns the lights that may reach the shape at its present place. */
  List<LightInstance> reaching() {
    return lighting.reaching(shape, ShapeProgram.MAX_LIGHTS - 1); // One for the headlight.
  }

  /**
   * Converts a number of indices drawn from a refined mesh to the corresponding number of the
   * shape's own mesh, so that statistics count the model's polygons.
   *
   * @param all the indices of the refinement level that is drawn
   */
  long own(long drawn, int all) {
    int own = source.indexCount();
    return all == own ? drawn : Math.round(drawn / 3.0 * own / all) * 3;
  }
}
