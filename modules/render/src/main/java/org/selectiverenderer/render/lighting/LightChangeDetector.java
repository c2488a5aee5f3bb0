package org.selectiverenderer.render.lighting;

import java.util.List;
import org.selectiverenderer.browser.instance.Light;
import org.selectiverenderer.browser.instance.LightInstance;

/** Detects that a point or spot light has changed its fields, or is switched on or off. */
public final class LightChangeDetector {
  private final LightInstance[] lights;
  private final Light[] fields;
  private final boolean[] on;

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
    changed();
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
}
