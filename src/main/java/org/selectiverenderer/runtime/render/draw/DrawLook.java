package org.selectiverenderer.runtime.render.draw;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.Stroke;
import org.selectiverenderer.runtime.instance.Surroundings;
import org.selectiverenderer.runtime.render.gpu.DetailTextures;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.ShapePrograms;
import org.selectiverenderer.runtime.render.mesh.VertexLayout;

/**
 * All that one call of the drawing needs beside the triangles: shapes of equal looks that are lit
 * alike may be drawn by one call.
 *
 * @param byPixel the programs that light it at its pixels
 * @param byVertex those that light it at its vertices
 * @param reaching the lights that reach the shape
 * @param material as the light model wants it; twelve numbers
 * @param textureTransform nine numbers
 * @param around the fog and planes whose scope it is in
 * @param detail of a surface that has more than that, else null
 * @param author what the program of an author makes of it, else null
 */
record DrawLook(
    ShapePrograms.Family byPixel,
    ShapePrograms.Family byVertex,
    @Nullable GpuTexture texture,
    List<LightInstance> reaching,
    Numbers material,
    Numbers textureTransform,
    boolean blended,
    VertexLayout layout,
    Stroke stroke,
    Surroundings around,
    Mesh.Primitive primitive,
    boolean solid,
    @Nullable DetailTextures detail,
    @Nullable AuthorLook author) {

  /** The same with other programs. */
  DrawLook drawnBy(ShapePrograms.Family pixel, ShapePrograms.Family vertex) {
    return new DrawLook(
        pixel,
        vertex,
        texture,
        reaching,
        material,
        textureTransform,
        blended,
        layout,
        stroke,
        around,
        primitive,
        solid,
        detail,
        author);
  }

  /** The same in another material. */
  DrawLook of(Numbers other) {
    return new DrawLook(
        byPixel,
        byVertex,
        texture,
        reaching,
        other,
        textureTransform,
        blended,
        layout,
        stroke,
        around,
        primitive,
        solid,
        detail,
        author);
  }
}
