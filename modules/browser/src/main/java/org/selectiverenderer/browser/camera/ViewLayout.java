package org.selectiverenderer.browser.camera;

import java.util.List;
import org.selectiverenderer.browser.World;

/**
 * Computes the views of a frame: one for a window, two for stereo. All views show the same state of
 * the world and the same viewer pose and share one culling pass.
 */
@FunctionalInterface
public interface ViewLayout {
  /** One view: the viewer's own, over the whole render target. */
  ViewLayout MONO =
      (world, width, height, range) ->
          List.of(
              new EyeView(
                  Camera.of(world.viewer(), width, height, range.near(), range.far()),
                  EyeView.Channel.ALL));

  /**
   * Returns the views of the present frame. Parts of the target that no view covers stay black.
   *
   * @param width the target's width in pixels
   * @param height the target's height in pixels
   * @param range the near and far plane
   * @return the views, at least one
   */
  List<EyeView> views(World world, int width, int height, DepthRange range);

  /**
   * Returns whether the world is drawn; otherwise only the two-dimensional primitives, on black.
   */
  default boolean showsWorld() {
    return true;
  }

  /**
   * Returns the primitives drawn over a view.
   *
   * @param view the view's index in the list
   * @param width the view's width in pixels
   * @param height the view's height in pixels
   */
  default List<Primitive2D> marks(int view, int width, int height) {
    return List.of();
  }
}
