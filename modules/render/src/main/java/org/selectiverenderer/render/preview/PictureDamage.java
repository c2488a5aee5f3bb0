package org.selectiverenderer.render.preview;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.Light;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ScopedEffects;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.draw.DrawItem;
import org.selectiverenderer.render.draw.LightingContext;
import org.selectiverenderer.render.draw.PixelRectangle;

/**
 * Finds the parts of a picture in which it differs from the previous one of the same scene: the
 * damage, as window systems call it. Where an effect reaches beyond the shape that has changed,
 * such as a light, or cannot be told from the shapes, such as a movie, that is the whole picture.
 */
final class PictureDamage {
  /** Pixels by which edges and their smoothing reach beyond a projected box. */
  private static final int MARGIN = 3;

  private static final double NEAR = 1e-6;

  private @Nullable Picture last;

  /** The state of everything that a picture shows. */
  private record Picture(
      InstanceTree tree,
      Camera camera,
      LightingContext setting,
      List<LightState> lights,
      Map<ShapeInstance, ShapeState> shapes,
      List<BoxOverlay> boxes) {}

  private record LightState(LightInstance instance, Light light, boolean on, Matrix4dc world) {
    static LightState of(LightInstance instance) {
      return new LightState(
          instance, instance.light(), instance.on(), new Matrix4d(instance.world()));
    }

    boolean same(LightState other) {
      return instance == other.instance
          && light == other.light
          && on == other.on
          && world.equals(other.world, 0);
    }
  }

  /**
   * A shape as it was drawn.
   *
   * @param steady whether it looks the same as long as its item and its place are
   */
  private record ShapeState(
      DrawItem item, boolean masked, boolean steady, Matrix4dc world, double[] bounds) {
    static ShapeState of(DrawItem item, boolean masked) {
      ShapeInstance shape = item.shape();
      boolean steady =
          item.author() == null
              && shape.films().isEmpty()
              && shape.cubes().isEmpty()
              && item.around().equals(ScopedEffects.NONE);
      return new ShapeState(
          item, masked, steady, new Matrix4d(shape.world()), shape.bounds().clone());
    }

    boolean same(ShapeState other) {
      return item == other.item
          && masked == other.masked
          && world.equals(other.world, 0)
          && Arrays.equals(bounds, other.bounds);
    }
  }

  /**
   * Compares what is to be drawn with the previous picture, and remembers it.
   *
   * @param items all draw items of the tree, shown or not
   * @return the rectangles that have to be drawn again; empty if all has to be
   */
  Optional<List<PixelRectangle>> next(
      InstanceTree tree,
      List<DrawItem> items,
      Camera camera,
      LightingContext setting,
      PreviewOptions marking) {
    Picture before = last;
    Picture now =
        new Picture(
            tree,
            camera,
            setting,
            tree.lights().stream().map(LightState::of).toList(),
            shapes(items, marking.masked()),
            marking.boxes());
    last = now;
    boolean comparable =
        before != null
            && before.tree == tree
            && before.camera.equals(camera)
            && same(before.setting, setting)
            && same(before.lights, now.lights)
            && now.shapes.values().stream().allMatch(ShapeState::steady);
    return comparable ? damage(before, now) : Optional.empty();
  }

  private static Map<ShapeInstance, ShapeState> shapes(
      List<DrawItem> items, Set<ShapeInstance> masked) {
    Map<ShapeInstance, ShapeState> shapes = new IdentityHashMap<>();
    for (DrawItem item : items) {
      if (item.shape().shown()) {
        shapes.put(item.shape(), ShapeState.of(item, masked.contains(item.shape())));
      }
    }
    return shapes;
  }

  private static boolean same(LightingContext one, LightingContext other) {
    return one.headlight() == other.headlight()
        && one.fog().equals(other.fog())
        && one.over() == other.over()
        && one.backdrop().isPresent() == other.backdrop().isPresent()
        && (one.backdrop().isEmpty() || same(one.backdrop().get(), other.backdrop().get()));
  }

  private static boolean same(Background one, Background other) {
    return one == other
        || Arrays.equals(one.skyColor(), other.skyColor())
            && Arrays.equals(one.skyAngle(), other.skyAngle())
            && Arrays.equals(one.groundColor(), other.groundColor())
            && Arrays.equals(one.groundAngle(), other.groundAngle())
            && one.transparency() == other.transparency()
            && one.pictures().equals(other.pictures())
            && one.turn().equals(other.turn());
  }

  private static boolean same(List<LightState> one, List<LightState> other) {
    if (one.size() != other.size()) {
      return false;
    }
    for (int i = 0; i < one.size(); i++) {
      if (!one.get(i).same(other.get(i))) {
        return false;
      }
    }
    return true;
  }

  private static Optional<List<PixelRectangle>> damage(Picture before, Picture now) {
    Rectangles rectangles = new Rectangles(now.camera);
    now.shapes.forEach(
        (shape, state) -> {
          ShapeState was = before.shapes.get(shape);
          if (was == null || !was.same(state)) {
            rectangles.add(state);
          }
        });
    before.shapes.forEach(
        (shape, was) -> {
          ShapeState state = now.shapes.get(shape);
          if (state == null || !was.same(state)) {
            rectangles.add(was);
          }
        });
    boxesOnlyIn(before.boxes, now.boxes).forEach(rectangles::add);
    boxesOnlyIn(now.boxes, before.boxes).forEach(rectangles::add);
    return rectangles.unbounded ? Optional.empty() : Optional.of(rectangles.found.rectangles());
  }

  /** Returns the boxes that are not in the same place of another list. */
  private static List<Matrix4dc> boxesOnlyIn(List<BoxOverlay> boxes, List<BoxOverlay> others) {
    List<Matrix4dc> only = new ArrayList<>();
    for (int i = 0; i < boxes.size(); i++) {
      BoxOverlay box = boxes.get(i);
      BoxOverlay other = i < others.size() ? others.get(i) : null;
      if (other == null
          || !box.place().equals(other.place(), 0)
          || !Arrays.equals(box.edges(), other.edges())
          || !Arrays.equals(box.sides(), other.sides())) {
        only.add(box.place());
      }
    }
    return only;
  }

  /** A few rectangles that hold the pixels of all that is added. */
  private static final class Rectangles {
    final DamageRegion found = new DamageRegion();
    private final Camera camera;
    private final Matrix4dc clip;

    /** Whether something reaches behind the viewer, where it has no place in the picture. */
    boolean unbounded;

    Rectangles(Camera camera) {
      this.camera = camera;
      clip = camera.projection().mul(camera.view(), new Matrix4d());
    }

    void add(ShapeState state) {
      // The width of lines and points is one of pixels.
      unbounded |= state.item.source().primitive() != Mesh.Primitive.TRIANGLES;
      double[] box = state.bounds;
      if (box[0] <= box[3]) {
        Matrix4d cube = new Matrix4d();
        cube.translation((box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2);
        add(cube.scale(box[3] - box[0], box[4] - box[1], box[5] - box[2]));
      }
    }

    /** Adds the cube of side 1 about the origin in a place. */
    void add(Matrix4dc place) {
      double left = Double.POSITIVE_INFINITY;
      double bottom = Double.POSITIVE_INFINITY;
      double right = Double.NEGATIVE_INFINITY;
      double top = Double.NEGATIVE_INFINITY;
      for (int corner = 0; corner < 8; corner++) {
        double x = (corner & 1) - 0.5;
        double y = (corner >> 1 & 1) - 0.5;
        double z = (corner >> 2) - 0.5;
        Vector4d point = clip.transform(place.transform(new Vector4d(x, y, z, 1)));
        double column = (point.x / point.w + 1) / 2 * camera.width();
        double row = (point.y / point.w + 1) / 2 * camera.height();
        unbounded |= point.w < NEAR || !Double.isFinite(column) || !Double.isFinite(row);
        left = Math.min(left, column);
        bottom = Math.min(bottom, row);
        right = Math.max(right, column);
        top = Math.max(top, row);
      }
      int x = within(Math.floor(left) - MARGIN, camera.width());
      int y = within(Math.floor(bottom) - MARGIN, camera.height());
      int endX = within(Math.ceil(right) + MARGIN, camera.width());
      int endY = within(Math.ceil(top) + MARGIN, camera.height());
      if (!unbounded && endX > x && endY > y) {
        found.add(new PixelRectangle(camera.x() + x, camera.y() + y, endX - x, endY - y));
      }
    }

    private static int within(double pixel, int most) {
      return (int) Math.max(0, Math.min(pixel, most));
    }
  }
}
