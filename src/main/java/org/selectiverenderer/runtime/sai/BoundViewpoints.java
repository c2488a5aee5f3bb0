package org.selectiverenderer.runtime.sai;

import java.util.List;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.scene.Node;

/**
 * Goes through the viewpoints of the scene that is shown. There is one layer: all numbers mean it.
 */
final class BoundViewpoints {
  private final World world;
  private final Binding binding;

  BoundViewpoints(World world, Binding binding) {
    this.world = world;
    this.binding = binding;
  }

  /**
   * Binds one counted from the bound one, around the ends of the list.
   *
   * @param steps +1 for the next, -1 for the one before
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
