package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.render.gpu.GpuMesh;
import org.selectiverenderer.render.gpu.GpuTexture;
import org.selectiverenderer.render.gpu.ShapeProgram;
import org.selectiverenderer.render.gpu.ShapeProgramCache;

/** Draws items for one eye, changing only the GL state that differs from the item before. */
final class DrawItemRenderer {
  private final GL3 gl;
  private final VisibleSet visible;
  private final Camera camera;
  private final EyeSpaceLights lights;
  private final EyeSpaceEffects scenery;
  private final float pointSize;
  private final FrameFlusher portions;
  private final Matrix4d toEye = new Matrix4d();
  private final Matrix4d toClip = new Matrix4d();
  private final Matrix4d normals = new Matrix4d();
  private final float[] object = new float[40];
  private @Nullable ShapeProgram program;
  private @Nullable GpuTexture texture;
  private @Nullable GpuMesh mesh;
  private int planes;

  DrawItemRenderer(
      GL3 gl,
      VisibleSet visible,
      Camera camera,
      EyeSpaceLights lights,
      EyeSpaceEffects scenery,
      float pointSize,
      FrameFlusher portions) {
    this.pointSize = pointSize;
    this.portions = portions;
    this.gl = gl;
    this.visible = visible;
    this.camera = camera;
    this.lights = lights;
    this.scenery = scenery;
  }

  /** Draws opaque items. */
  void paint(int from, int to) {
    for (int i = from; i < to; i++) {
      DrawItem item = visible.calls.get(i);
      if (visible.firstRange[i] == visible.firstRange[i + 1]) {
        continue;
      }
      bind(item, visible.frontOnly(i));
      cull(item.mesh().solid() && areas(item) ? GL.GL_BACK : 0);
      if (item.author() == null) {
        elements(i);
      } else {
        // The framebuffer's alpha stays 1, whatever alpha the custom shader writes.
        gl.glEnable(GL.GL_BLEND);
        gl.glBlendFuncSeparate(GL.GL_ONE, GL.GL_ZERO, GL.GL_ZERO, GL.GL_ONE);
        authored(item.author(), i);
        gl.glDisable(GL.GL_BLEND);
      }
    }
  }

  /** Draws with a custom shader, which need not set the size of points. */
  private void authored(CustomShaderBinding look, int i) {
    boolean open = visible.calls.get(i).mesh().mode() == GL.GL_POINTS && !look.sizesPoints();
    if (open) {
      gl.glDisable(GL3.GL_PROGRAM_POINT_SIZE);
      gl.glPointSize(pointSize);
    }
    elements(i);
    if (open) {
      gl.glEnable(GL3.GL_PROGRAM_POINT_SIZE);
    }
  }

  /** Draws blended items; of two-sided ones the back faces first. */
  void blend(int from, int to) {
    program = null;
    texture = null;
    mesh = null;
    for (int i = from; i < to; i++) {
      DrawItem item = visible.calls.get(i);
      bind(item, false);
      if (!item.mesh().solid() && areas(item)) {
        cull(GL.GL_FRONT);
        elements(i);
      }
      cull(areas(item) ? GL.GL_BACK : 0);
      if (item.author() == null) {
        elements(i);
      } else {
        authored(item.author(), i);
      }
    }
  }

  /**
   * Returns whether face culling applies: lines and points have no sides, even where they are drawn
   * as rectangles.
   */
  private static boolean areas(DrawItem item) {
    return item.mesh().mode() == GL.GL_TRIANGLES;
  }

  private void cull(int side) {
    if (side == 0) {
      gl.glDisable(GL.GL_CULL_FACE);
    } else {
      gl.glEnable(GL.GL_CULL_FACE);
      gl.glCullFace(side);
    }
  }

  private void bind(DrawItem item, boolean frontOnly) {
    EyeSpaceLights.Packed packed = lights.of(item.reaching());
    if (item.author() != null) {
      author(item, item.author(), packed);
      return;
    }
    ShapeProgramCache.Family programs = item.programs();
    EyeSpaceEffects.Packed around = scenery.of(item);
    ShapeProgram needed =
        (frontOnly ? programs.front() : programs).get(gl, packed.counts(), around.scenery());
    if (needed != program) {
      program = needed;
      needed.use(gl, pointSize);
      planes(around.scenery().planes());
    }
    if (item.texture() != null && item.texture() != texture) {
      texture = item.texture();
      item.texture().bind(gl);
    }
    if (item.mesh() != mesh) {
      mesh = item.mesh();
      item.mesh().bind(gl);
    }
    needed.material(gl, item.numbers(), item.textureTransform());
    if (item.detail() != null) {
      needed.detail(gl, item.detail(), camera.view());
      texture = null;
    }
    needed.lights(gl, packed.numbers());
    around.send(gl, needed);
    place(item.place());
    needed.object(gl, object);
    boolean mirrored = areas(item) && toEye.determinant3x3() < 0;
    gl.glFrontFace(mirrored ? GL.GL_CW : GL.GL_CCW);
  }

  /** Binds a custom shader with its resources; the next item binds its own anew. */
  private void author(DrawItem item, CustomShaderBinding look, EyeSpaceLights.Packed packed) {
    program = null;
    texture = null;
    planes(0);
    if (item.mesh() != mesh) {
      mesh = item.mesh();
      item.mesh().bind(gl);
    }
    place(item.place());
    // Constant attributes for meshes without colours or normals.
    float[] numbers = item.numbers();
    gl.glVertexAttrib4f(2, numbers[0], numbers[1], numbers[2], numbers[3]);
    gl.glVertexAttrib3f(1, 0, 0, 1);
    look.send(gl, new UniformContext(item, camera, toEye, packed, scenery.fog(item)));
    gl.glFrontFace(areas(item) && toEye.determinant3x3() < 0 ? GL.GL_CW : GL.GL_CCW);
  }

  /** Enables as many clip distances as the program writes. */
  private void planes(int count) {
    for (int i = Math.min(planes, count); i < Math.max(planes, count); i++) {
      if (i < count) {
        gl.glEnable(GL3.GL_CLIP_DISTANCE0 + i);
      } else {
        gl.glDisable(GL3.GL_CLIP_DISTANCE0 + i);
      }
    }
    planes = count;
  }

  /** Disables all clip distances for what is drawn next. */
  void end() {
    planes(0);
  }

  /**
   * Computes the shape's matrices in double precision, so that large translations cancel before
   * they become floats.
   */
  private void place(Matrix4dc world) {
    camera.view().mul(world, toEye);
    camera.projection().mul(toEye, toClip);
    toClip.get(object);
    put(16, toEye);
    toEye.normal(normals);
    put(28, normals);
  }

  /** Writes the upper three rows of a matrix. */
  private void put(int at, Matrix4d m) {
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 4; column++) {
        object[at + 4 * row + column] = (float) m.get(column, row);
      }
    }
  }

  private void elements(int i) {
    GpuMesh drawn = visible.calls.get(i).mesh();
    int from = visible.firstRange[i];
    int count = visible.firstRange[i + 1] - from;
    if (count == 1) {
      gl.glDrawElements(drawn.mode(), visible.count(from), drawn.indexType(), visible.offset(from));
    } else if (count > 1) {
      gl.glMultiDrawElements(
          drawn.mode(), visible.counts(from), drawn.indexType(), visible.offsets(from), count);
    }
    portions.drawn(gl, visible.count(from, from + count));
  }
}
