package org.selectiverenderer.runtime.camera;

import java.util.List;
import org.selectiverenderer.runtime.World;

/**
 * The views of which a frame consists: all of one update of the world and one pose of the viewer,
 * culled once for all of them.
 */
@FunctionalInterface
public interface ViewLayout {
  /** The viewer's own view over the whole target. */
  ViewLayout MONO =
      (world, width, height, range) ->
          List.of(
              new EyeView(
                  Camera.of(world.viewer(), width, height, range.near(), range.far()),
                  EyeView.Channel.ALL));

  /**
   * The views of the present frame. Where they leave parts of the target free, these are black.
   *
   * @param width of the target in pixels
   * @param height of the target in pixels
   * @param range of depth about the viewer
   * @return at least one
   */
  List<EyeView> views(World world, int width, int height, DepthRange range);

  /** Whether the world is drawn; else there are only marks on black. */
  default boolean showsWorld() {
    return true;
  }

  /**
   * What is drawn over a view.
   *
   * @param view its number in the list
   * @param width of the view in pixels
   * @param height of the view in pixels
   */
  default List<Mark> marks(int view, int width, int height) {
    return List.of();
  }
}
