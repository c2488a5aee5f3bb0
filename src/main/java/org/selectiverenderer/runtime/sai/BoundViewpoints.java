package org.selectiverenderer.runtime.sai;

import java.util.List;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.scene.Node;

/**
 * Binds the next, previous, first or last viewpoint of the scene that is shown. Layer numbers are
 * ignored.
 */
final class BoundViewpoints {
  private final World world;
  private final Binding binding;

  BoundViewpoints(World world, Binding binding) {
    this.world = world;
    this.binding = binding;
  }

  /**
   * Binds a viewpoint relative to the bound one, cyclically.
   *
   * @param steps +1 for the next, -1 for the previous one
   */
  void go(int steps) {
    binding.execute(() -> world.views().goToViewpoint(steps));
  }

  void first() {
    to(0);
  }

  void last() {
    to(-1);
  }

  private void to(int index) {
    binding.execute(
        () -> {
          List<Node> all = world.views().viewpoints();
          if (!all.isEmpty()) {
            world.views().goTo(all.get(Math.floorMod(index, all.size())));
          }
        });
  }
}
