package org.selectiverenderer.enricher.preview;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.Collection;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Draws the floor plan of a scene: rasterizes the triangles below the cut from above with a height
 * buffer, and collects the line segments in which the cut meets triangles. Runs on the CPU, since
 * it is done once for a state of a scene, and a plan has no perspective, lights or textures.
 */
final class FloorPlanRenderer {
  /** Pixels of the image's longer side. */
  private static final int PIXELS = 1800;

  /** Least opacity of what is drawn, so that glass and soft shadows are left out. */
  private static final float OPAQUE = 0.6f;

  /** Most wall segments that are kept. */
  private static final int MOST_WALLS = 400_000;

  private final BoundingBox extent;
  private final double cut;
  private final double scale;
  private final int width;
  private final int height;
  private final float[] top;
  private final int[] colours;
  private float[] walls = new float[1024];
  private int wallNumbers;

  private FloorPlanRenderer(BoundingBox extent, double cut) {
    this.extent = extent;
    this.cut = cut;
    double longer = Math.max(extent.width(), extent.depth());
    scale = PIXELS / longer;
    width = Math.max(1, (int) Math.ceil(extent.width() * scale));
    height = Math.max(1, (int) Math.ceil(extent.depth() * scale));
    top = new float[width * height];
    Arrays.fill(top, Float.NEGATIVE_INFINITY);
    colours = new int[width * height];
  }

  /**
   * Draws the plan of a scene.
   *
   * @param cut height of the cut in metres, world Y; empty for one between floor and ceiling
   * @param hidden shapes that are left out
   * @return empty if nothing visible covers any ground
   */
  static Optional<FloorPlanImage> of(
      PreviewScene scene, OptionalDouble cut, Set<ShapeInstance> hidden) {
    PlanShapes shapes = PlanShapes.of(scene.world().instances().shapes(), hidden);
    return shapes
        .extent()
        .map(
            all ->
                new FloorPlanRenderer(
                        all,
                        cut.orElseGet(
                            () -> new StoreyFinder(shapes.drawn()).cut(scene.startHeight())))
                    .draw(shapes.drawn()));
  }

  private FloorPlanImage draw(Collection<ShapeInstance> shapes) {
    for (ShapeInstance shape : shapes) {
      if (shape.bounds()[1] <= cut) {
        shape.mesh().ifPresent(mesh -> draw(mesh, shape));
      }
    }
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
    image.setRGB(0, 0, width, height, colours, 0, width);
    return new FloorPlanImage(extent, image, Arrays.copyOf(walls, wallNumbers), cut);
  }

  private void draw(Mesh mesh, ShapeInstance shape) {
    if (mesh.primitive() != Mesh.Primitive.TRIANGLES
        || 1 - shape.surface().transparency() < OPAQUE) {
      return;
    }
    Matrix4dc world = shape.world();
    float[] colour = colour(shape.surface());
    float[] p = mesh.positions();
    Vector3d[] at = {new Vector3d(), new Vector3d(), new Vector3d()};
    for (int i = 0; i + 2 < mesh.indices().length; i += 3) {
      for (int k = 0; k < 3; k++) {
        int v = 3 * mesh.indices()[i + k];
        world.transformPosition(at[k].set(p[v], p[v + 1], p[v + 2]));
      }
      float[] own = mesh.colors();
      if (own != null && own[4 * mesh.indices()[i] + 3] < OPAQUE) {
        continue;
      }
      double low = Math.min(at[0].y, Math.min(at[1].y, at[2].y));
      double high = Math.max(at[0].y, Math.max(at[1].y, at[2].y));
      if (low < cut && high > cut) {
        wall(at);
      }
      if (low < cut) {
        fill(at[0], at[1], at[2], own == null ? colour : colour(own, 4 * mesh.indices()[i]));
      }
    }
  }

  /** Returns a surface's colour; a light grey for textured ones, whose texture is not sampled. */
  private static float[] colour(SurfaceMaterial surface) {
    if (surface.texture() != null) {
      return new float[] {0.82f, 0.8f, 0.77f};
    }
    return colour(surface.lit() ? surface.diffuse() : surface.emissive(), 0);
  }

  private static float[] colour(float[] own, int from) {
    float[] pale = new float[3];
    for (int i = 0; i < 3; i++) {
      pale[i] = 0.35f + 0.65f * Math.max(0, Math.min(1, own[from + i]));
    }
    return pale;
  }

  /** Adds the line segment in which the cut meets a triangle. */
  private void wall(Vector3d[] at) {
    float[] line = new float[4];
    int ends = 0;
    for (int k = 0; k < 3 && ends < 2; k++) {
      Vector3d a = at[k];
      Vector3d b = at[(k + 1) % 3];
      if (a.y < cut != b.y < cut) {
        double t = (cut - a.y) / (b.y - a.y);
        line[2 * ends] = (float) (a.x + t * (b.x - a.x));
        line[2 * ends + 1] = (float) (a.z + t * (b.z - a.z));
        ends++;
      }
    }
    if (ends == 2 && wallNumbers < 4 * MOST_WALLS) {
      if (wallNumbers + 4 > walls.length) {
        walls = Arrays.copyOf(walls, 2 * walls.length);
      }
      System.arraycopy(line, 0, walls, wallNumbers, 4);
      wallNumbers += 4;
    }
  }

  private void fill(Vector3d a, Vector3d b, Vector3d c, float[] colour) {
    double ax = (a.x - extent.minX()) * scale;
    double az = (a.z - extent.minZ()) * scale;
    double bx = (b.x - extent.minX()) * scale;
    double bz = (b.z - extent.minZ()) * scale;
    double cx = (c.x - extent.minX()) * scale;
    double cz = (c.z - extent.minZ()) * scale;
    double area = (bx - ax) * (cz - az) - (cx - ax) * (bz - az);
    if (Math.abs(area) < 1e-9) {
      return; // vertical
    }
    int rgb = shaded(a, b, c, colour);
    int x0 = (int) Math.max(0, Math.floor(Math.min(ax, Math.min(bx, cx))));
    int x1 = (int) Math.min(width - 1, Math.ceil(Math.max(ax, Math.max(bx, cx))));
    int z0 = (int) Math.max(0, Math.floor(Math.min(az, Math.min(bz, cz))));
    int z1 = (int) Math.min(height - 1, Math.ceil(Math.max(az, Math.max(bz, cz))));
    for (int z = z0; z <= z1; z++) {
      for (int x = x0; x <= x1; x++) {
        double px = x + 0.5;
        double pz = z + 0.5;
        double u = ((bx - px) * (cz - pz) - (cx - px) * (bz - pz)) / area;
        double v = ((cx - px) * (az - pz) - (ax - px) * (cz - pz)) / area;
        double w = 1 - u - v;
        double y = u * a.y + v * b.y + w * c.y;
        int at = z * width + x;
        if (u >= -1e-9 && v >= -1e-9 && w >= -1e-9 && y <= cut && y > top[at]) {
          top[at] = (float) y;
          colours[at] = rgb;
        }
      }
    }
  }

  /** Shades a triangle: horizontal ones light, steep ones dark. */
  private static int shaded(Vector3d a, Vector3d b, Vector3d c, float[] colour) {
    Vector3d normal = b.sub(a, new Vector3d()).cross(c.sub(a, new Vector3d())).normalize();
    double light = 0.45 + 0.5 * Math.abs(normal.y) + 0.05 * normal.x * Math.signum(normal.y);
    int rgb = 0xff;
    for (int i = 0; i < 3; i++) {
      rgb = rgb << 8 | (int) Math.round(255 * Math.min(1, colour[i] * light));
    }
    return rgb;
  }
}
