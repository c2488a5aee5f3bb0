package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.instance.GeneratedCubeTexture;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.TextureSource;
import org.selectiverenderer.render.gpu.GpuTexture;

/**
 * Renders GeneratedCubeMapTextures (X3D 4.0, 34.4.2): the scene as seen from the centre of a shape,
 * along the axes of the world. A shape does not see itself in its own cube map, and sees other
 * generated cube maps as they were last rendered. A cube map on several shapes is rendered from the
 * first one that is shown. Belongs to the thread that owns the context.
 */
final class GeneratedCubeMapRenderer {
  /** The most cube maps rendered per frame; those that are updated always take turns. */
  private static final int MOST_A_FRAME = 4;

  /**
   * The most pixels of all generated cube maps together (200 MB); further ones get {@link #SMALL}
   * sides.
   */
  private static final long MOST_PIXELS = 50_000_000;

  private static final int SMALL = 16;

  /** The view direction and up vector of each face, in OpenGL's order. */
  private static final Vector3d[][] FACES = {
    {new Vector3d(1, 0, 0), new Vector3d(0, -1, 0)},
    {new Vector3d(-1, 0, 0), new Vector3d(0, -1, 0)},
    {new Vector3d(0, 1, 0), new Vector3d(0, 0, 1)},
    {new Vector3d(0, -1, 0), new Vector3d(0, 0, -1)},
    {new Vector3d(0, 0, 1), new Vector3d(0, -1, 0)},
    {new Vector3d(0, 0, -1), new Vector3d(0, -1, 0)}
  };

  /** Draws items of the scene as a camera sees them, into the current framebuffer. */
  @FunctionalInterface
  interface Scene {
    void draw(List<DrawItem> items, Camera camera);
  }

  private List<DrawItem> known = List.of();
  private Map<GpuTexture, List<DrawItem>> cubes = Map.of();
  private final Map<GpuTexture, Last> last = new HashMap<>();
  private long frame;
  private int buffer;
  private int depth;
  private int depthSide;

  /** The last rendering of a cube map: the update request that it answered, and the frame. */
  private record Last(long request, long frame) {
    static final Last NEVER = new Last(0, -1);
  }

  private record Due(GpuTexture texture, DrawItem from) {}

  /**
   * Returns the wanted texture, or a small cube map where there are many large ones already.
   *
   * @param others the textures on the graphics card
   */
  static TextureSource fitting(TextureSource wanted, Collection<GpuTexture> others) {
    if (!(wanted instanceof GeneratedCubeTexture cube)) {
      return wanted;
    }
    long pixels = 6L * cube.size() * cube.size();
    for (GpuTexture texture : others) {
      pixels += 6L * texture.side() * texture.side(); // 0 for other textures.
    }
    return pixels <= MOST_PIXELS
        ? cube
        : new GeneratedCubeTexture(cube.node(), Math.min(cube.size(), SMALL), cube.sampling());
  }

  /** Finds the generated cube maps among the items, if the list is a new one. */
  void follow(List<DrawItem> items) {
    if (items == known) {
      return;
    }
    known = items;
    Map<GpuTexture, List<DrawItem>> found = new LinkedHashMap<>();
    for (DrawItem item : items) {
      if (item.detail() != null) {
        item.detail().textures().forEach(texture -> add(texture, item, found));
      }
      if (item.author() != null) {
        item.author().textures().forEach(of -> of.ifPresent(texture -> add(texture, item, found)));
      }
    }
    cubes = found;
    last.keySet().retainAll(found.keySet());
  }

  private static void add(GpuTexture texture, DrawItem item, Map<GpuTexture, List<DrawItem>> to) {
    if (texture.generated().isPresent()) {
      List<DrawItem> on = to.computeIfAbsent(texture, key -> new ArrayList<>(1));
      if (!on.contains(item)) {
        on.add(item);
      }
    }
  }

  boolean isEmpty() {
    return cubes.isEmpty();
  }

  /**
   * Renders the cube maps that are due; restores the framebuffer and the viewport.
   *
   * @param eyes the cameras of the frame: a cube map that none of them sees need not be updated
   * @param near the distance of the near plane
   */
  void paint(GL3 gl, InstanceTree tree, List<Camera> eyes, double near, Scene scene) {
    frame++;
    List<Due> due = due(eyes);
    if (due.isEmpty()) {
      return;
    }
    int[] before = new int[5];
    gl.glGetIntegerv(GL.GL_FRAMEBUFFER_BINDING, before, 0);
    gl.glGetIntegerv(GL.GL_VIEWPORT, before, 1);
    for (Due cube : due) {
      paint(gl, cube, tree, near, scene);
    }
    gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, before[0]);
    gl.glViewport(before[1], before[2], before[3], before[4]);
  }

  private List<Due> due(List<Camera> eyes) {
    List<Frustum> frustums = eyes.stream().map(Frustum::of).toList();
    List<Due> due = new ArrayList<>();
    cubes.forEach(
        (texture, items) -> {
          var node = texture.generated().orElseThrow().node();
          boolean asked = last.getOrDefault(texture, Last.NEVER).request() < node.request();
          DrawItem first = null;
          boolean seen = false;
          for (DrawItem item : items) {
            if (item.shape().shown()) {
              first = first == null ? item : first;
              seen |= frustums.stream().anyMatch(eye -> sees(eye, item));
            }
          }
          if (first != null && (asked || (node.always() && seen))) {
            due.add(new Due(texture, first));
          }
        });
    due.sort(Comparator.comparing(cube -> last.getOrDefault(cube.texture(), Last.NEVER).frame()));
    return due.subList(0, Math.min(MOST_A_FRAME, due.size()));
  }

  private static boolean sees(Frustum eye, DrawItem item) {
    return item.anywhere() || eye.side(item.shape().bounds()) != Frustum.Side.OUTSIDE;
  }

  private void paint(GL3 gl, Due cube, InstanceTree tree, double near, Scene scene) {
    GpuTexture texture = cube.texture();
    double[] box = cube.from().shape().bounds();
    Vector3d eye =
        new Vector3d((box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2);
    last.put(texture, new Last(texture.generated().orElseThrow().node().request(), frame));
    if (!eye.isFinite()) {
      return; // An empty bounding box has no centre.
    }
    DepthRange range = DepthRange.of(tree, eye, 2 * near, 0);
    Matrix4d projection = new Matrix4d().setPerspective(Math.PI / 2, 1, range.near(), range.far());
    List<DrawItem> on = cubes.getOrDefault(texture, List.of());
    List<DrawItem> others = known.stream().filter(item -> !on.contains(item)).toList();
    bind(gl, texture.side());
    for (int face = 0; face < FACES.length; face++) {
      texture.drawOn(gl, face);
      Vector3d towards = FACES[face][0].add(eye, new Vector3d());
      Matrix4d view = new Matrix4d().setLookAt(eye, towards, FACES[face][1]);
      scene.draw(others, new Camera(view, projection, 0, 0, texture.side(), texture.side()));
    }
    texture.drawn(gl);
  }

  private void bind(GL3 gl, int side) {
    if (buffer == 0) {
      int[] name = new int[1];
      gl.glGenFramebuffers(1, name, 0);
      buffer = name[0];
      gl.glGenRenderbuffers(1, name, 0);
      depth = name[0];
    }
    gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, buffer);
    if (side != depthSide) {
      depthSide = side;
      gl.glBindRenderbuffer(GL.GL_RENDERBUFFER, depth);
      gl.glRenderbufferStorage(GL.GL_RENDERBUFFER, GL.GL_DEPTH_COMPONENT24, side, side);
      gl.glFramebufferRenderbuffer(
          GL.GL_FRAMEBUFFER, GL.GL_DEPTH_ATTACHMENT, GL.GL_RENDERBUFFER, depth);
    }
  }

  void dispose(GL3 gl) {
    if (buffer != 0) {
      gl.glDeleteFramebuffers(1, new int[] {buffer}, 0);
      gl.glDeleteRenderbuffers(1, new int[] {depth}, 0);
      buffer = 0;
      depthSide = 0;
    }
    cubes = Map.of();
    known = List.of();
    last.clear();
  }
}
