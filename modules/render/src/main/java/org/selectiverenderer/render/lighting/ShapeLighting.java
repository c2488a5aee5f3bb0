package org.selectiverenderer.render.lighting;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.Light;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;

/**
 * The lighting of a shape: per vertex or per pixel, and by which lights. It is valid as long as the
 * shape and its point and spot lights stay as they were; one made for a moving shape stays valid.
 */
public final class ShapeLighting {
  private final List<LightInstance> scope;
  private final List<LightInstance> reaching;
  private final boolean vertices;
  private final @Nullable Matrix4dc place;
  private final List<Placed> placed;
  private final @Nullable Unsteady unsteady;

  /** The state of a light when the lighting was decided. */
  private record Placed(LightInstance instance, Light light, boolean on, Matrix4dc world) {
    static Placed of(LightInstance instance) {
      return new Placed(instance, instance.light(), instance.on(), new Matrix4d(instance.world()));
    }

    /** Returns whether the light still has the same fields and place. */
    boolean stays() {
      return instance.light() == light && instance.world().equals(world, 0);
    }
  }

  /**
   * A moving shape or one with moving lights: it is lit per vertex whenever that is good enough at
   * the present place.
   *
   * @param longest the longest edge of the mesh, in its own coordinates
   */
  record Unsteady(double longest, double tolerance) {
    boolean fine(ShapeInstance shape, List<LightInstance> lights) {
      double length = longest * CurvatureTolerance.scale(shape.world());
      return new LightCuller(shape.bounds()).departure(lights, length) <= tolerance;
    }
  }

  /**
   * @param scope the lights in whose scope the shape lies
   * @param reaching those of the lights that reach the shape
   * @param lit whether the shape is lit at all
   * @param vertices whether per-vertex lighting of the drawn mesh looks like per-pixel lighting
   * @param unsteady null for a shape that stays where it is
   */
  ShapeLighting(
      ShapeInstance shape,
      List<LightInstance> scope,
      List<LightInstance> reaching,
      boolean lit,
      boolean vertices,
      @Nullable Unsteady unsteady) {
    this.scope = scope;
    this.reaching = reaching;
    this.vertices = vertices;
    this.unsteady = unsteady;
    List<Placed> lights = new ArrayList<>();
    for (LightInstance light : scope) {
      if (lit && light.light().kind() != Light.Kind.DIRECTIONAL && unsteady == null) {
        lights.add(Placed.of(light));
      }
    }
    placed = List.copyOf(lights);
    place = lights.isEmpty() ? null : new Matrix4d(shape.world());
  }

  /** Returns the lights in whose scope the shape lies. */
  public List<LightInstance> scope() {
    return scope;
  }

  /** Returns the lights that can reach the shape; for a moving shape all lights in scope. */
  public List<LightInstance> reaching() {
    return reaching;
  }

  /**
   * Returns the lights that can reach the shape at its present place, culled only if there would
   * otherwise be too many.
   *
   * @param most the most lights that are returned without culling
   */
  public List<LightInstance> reaching(ShapeInstance shape, int most) {
    return unsteady == null || reaching.size() <= most
        ? reaching
        : new LightCuller(shape.bounds()).of(reaching);
  }

  /**
   * Returns whether this decision is still valid for the present state of the shape and its lights.
   */
  public boolean current(ShapeInstance shape) {
    if (place == null) {
      return true;
    }
    for (int i = 0; i < placed.size(); i++) {
      Placed light = placed.get(i);
      // Per-pixel lighting is right whichever lights are on.
      if (!light.stays() || (vertices && light.on() != light.instance().on())) {
        return false;
      }
    }
    return stands(shape);
  }

  /** Returns whether the shape is still at the place that this was made for. */
  public boolean stands(ShapeInstance shape) {
    return place == null || shape.world().equals(place, 0);
  }

  /** Returns whether the shape is lit per vertex at its present place. */
  public boolean byVertex(ShapeInstance shape) {
    return vertices && (unsteady == null || unsteady.fine(shape, scope));
  }

  /** Returns whether {@link #byVertex} is constant as long as this is current. */
  public boolean settled() {
    return unsteady == null;
  }
}
