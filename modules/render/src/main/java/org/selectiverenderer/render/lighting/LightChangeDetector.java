package org.selectiverenderer.render.lighting;

import java.util.List;
import org.joml.Matrix4dc;
import org.selectiverenderer.browser.instance.Light;
import org.selectiverenderer.browser.instance.LightInstance;

/** Detects that a point or spot light has changed its fields, is switched on or off, or moves. */
public final class LightChangeDetector {
  private final LightInstance[] lights;
  private final Light[] fields;
  private final boolean[] on;
  private final Matrix4dc[] places;

  /**
   * @param all all lights of a scene
   */
  public LightChangeDetector(List<LightInstance> all) {
    lights =
        all.stream()
            .filter(light -> light.light().kind() != Light.Kind.DIRECTIONAL)
            .toArray(LightInstance[]::new);
    fields = new Light[lights.length];
    on = new boolean[lights.length];
    places = new Matrix4dc[lights.length];
    changed();
    moved();
  }

  /** Returns whether some lights have changed since the last call. */
  public boolean changed() {
    boolean changed = false;
    for (int i = 0; i < lights.length; i++) {
      Light now = lights[i].light();
      changed |= fields[i] != now || on[i] != lights[i].on();
      fields[i] = now;
      on[i] = lights[i].on();
    }
    return changed;
  }

  /** Returns whether some lights have moved since the last call. */
  public boolean moved() {
    boolean moved = false;
    for (int i = 0; i < lights.length; i++) {
      Matrix4dc place = lights[i].world(); // Another object whenever a group above has moved.
      moved |= places[i] != place;
      places[i] = place;
    }
    return moved;
  }
}
