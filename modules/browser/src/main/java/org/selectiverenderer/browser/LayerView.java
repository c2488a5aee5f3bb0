package org.selectiverenderer.browser;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.Fog;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.Viewer;

/**
 * A visible layer of a scene with everything a renderer needs to draw it (X3D 4.0, 35.2). A scene
 * without a LayerSet has one layer.
 *
 * @param instances the instances in the layer
 * @param viewer the layer's viewer; in the active layer this is the user's viewer
 * @param backdrop the layer's background; empty if the layers below show through
 * @param navigationInfo the NavigationInfo bound in the layer
 * @param viewpoint the viewpoint bound in the layer
 * @param part the part of the picture that the layer is drawn into
 * @param active whether the user navigates in this layer
 */
public record LayerView(
    InstanceTree instances,
    Viewer viewer,
    Optional<Background> backdrop,
    Fog fog,
    Optional<Node> navigationInfo,
    Optional<Node> viewpoint,
    Part part,
    boolean active) {

  /** A rectangular part of a picture; 0..1 from the left and from the bottom. */
  public record Part(double left, double right, double bottom, double top) {
    /** The whole picture. */
    public static final Part WHOLE = new Part(0, 1, 0, 1);

    // Written out, as records link theirs when first called: the first frame would wait for it.
    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof Part one
          && Double.compare(left, one.left) == 0
          && Double.compare(right, one.right) == 0
          && Double.compare(bottom, one.bottom) == 0
          && Double.compare(top, one.top) == 0;
    }

    @Override
    public int hashCode() {
      int across = 31 * Double.hashCode(left) + Double.hashCode(right);
      return 31 * (31 * across + Double.hashCode(bottom)) + Double.hashCode(top);
    }

    /**
     * Returns the part given by the {@code clipBoundary} of a Viewport (X3D 4.0, 35.4.4); the whole
     * picture if that boundary is empty.
     */
    static Part of(float[] boundary) {
      if (boundary.length < 4) {
        return WHOLE;
      }
      double[] at = new double[4];
      for (int i = 0; i < 4; i++) {
        at[i] = Math.max(0, Math.min(1, boundary[i]));
      }
      return at[0] < at[1] && at[2] < at[3] ? new Part(at[0], at[1], at[2], at[3]) : WHOLE;
    }

    public double width() {
      return right - left;
    }

    public double height() {
      return top - bottom;
    }
  }
}
