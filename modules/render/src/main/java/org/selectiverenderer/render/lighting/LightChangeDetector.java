package org.selectiverenderer.render.lighting;

import org.joml.Matrix4dc;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.Light;
import org.selectiverenderer.browser.instance.LightInstance;

/** Detects that a point or spot light has changed its fields, is switched on or off, or moves. */
public final class LightChangeDetector {
  private final InstanceTree tree;
  private final LightInstance[] lights;
  private final Light[] fields;
  private final boolean[] on;
  private final Matrix4dc[] places;
  private long version;
  private boolean changed;
  private boolean moved;

  /** Makes a detector of changes from now on. */
  public LightChangeDetector(InstanceTree tree) {
    this.tree = tree;
    lights =
        tree.lights().stream()
            .filter(light -> light.light().kind() != Light.Kind.DIRECTIONAL)
            .toArray(LightInstance[]::new);
    fields = new Light[lights.length];
    on = new boolean[lights.length];
    places = new Matrix4dc[lights.length];
    compare();
    changed = false;
    moved = false;
  }

  /** Compares the lights with what they were at the last call. */
  public void look() {
    changed = false;
    moved = false;
    if (tree.lightVersion() != version) {
      compare();
    }
  }

  private void compare() {
    version = tree.lightVersion();
    for (int i = 0; i < lights.length; i++) {
      Light now = lights[i].light();
      changed |= fields[i] != now || on[i] != lights[i].on();
      fields[i] = now;
      on[i] = lights[i].on();
      Matrix4dc place = lights[i].world(); // Another object whenever a group above has moved.
      moved |= places[i] != place;
      places[i] = place;
    }
  }

  /** Returns whether some lights had changed at the last {@link #look}. */
  public boolean changed() {
    return changed;
  }

  /** Returns whether some lights had moved at the last {@link #look}. */
  public boolean moved() {
    return moved;
  }
}
