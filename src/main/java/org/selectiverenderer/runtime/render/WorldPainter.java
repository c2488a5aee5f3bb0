package org.selectiverenderer.runtime.render;

import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.navigation.Navigation;
import org.selectiverenderer.runtime.scene.Node;

/**
 * Draws a world as its viewer sees it: the bound NavigationInfo decides about headlight and depth
 * range, the bound Background about what is behind. Belongs to the thread that owns the context.
 */
final class WorldPainter {
  private final SceneRenderer renderer = new SceneRenderer(2);
  private Drawn drawn = new Drawn(0, 0);

  /** Sends all meshes and textures of the world to the graphics card. */
  void prepare(GL3 gl, World world) {
    world.hold(() -> renderer.prepare(gl, world.instances()));
  }

  /**
   * Draws over a whole target of that size while no other thread changes the world; returns what
   * was drawn.
   */
  Drawn paint(GL3 gl, World world, int width, int height) {
    world.hold(() -> drawn = paintHeld(gl, world, width, height));
    return drawn;
  }

  private Drawn paintHeld(GL3 gl, World world, int width, int height) {
    renderer.prepare(gl, world.instances());
    Optional<Node> info = world.bindables().bound("NavigationInfo");
    DepthRange range =
        DepthRange.of(
            world.instances(),
            world.viewer().position(),
            info.map(Navigation::of).orElse(Navigation.WALKING).radius(),
            info.map(node -> (double) node.number("visibilityLimit")).orElse(0.0));
    Camera camera = Camera.of(world.viewer(), width, height, range.near(), range.far());
    Visible seen = renderer.cull(List.of(camera));
    boolean headlight = info.map(node -> node.bool("headlight")).orElse(true);
    renderer.draw(gl, seen, camera, world.backdrop(), headlight);
    return new Drawn(seen.shapes(), seen.indices() / 3);
  }

  void dispose(GL3 gl) {
    renderer.dispose(gl);
  }
}
