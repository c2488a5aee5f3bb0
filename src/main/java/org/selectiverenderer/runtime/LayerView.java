package org.selectiverenderer.runtime;

import java.util.Optional;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.instance.Fog;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.viewer.Viewer;

/**
 * A layer of a scene as it is seen (X3D 4.0, 35.2). A scene without a LayerSet is one layer.
 *
 * @param instances what is in it
 * @param viewer who sees it; the user's own in the active layer
 * @param backdrop behind it; empty where the layers below are seen
 * @param navigationInfo that is bound in it
 * @param viewpoint that is bound in it
 * @param part of the picture that it is drawn into
 * @param active whether it is the one that the user walks in
 */
public record LayerView(
    InstanceTree instances,
    Viewer viewer,
    Optional<Backdrop> backdrop,
    Fog fog,
    Optional<Node> navigationInfo,
    Optional<Node> viewpoint,
    Part part,
    boolean active) {

  /** A part of a picture, 0..1 from its left and from its bottom. */
  public record Part(double left, double right, double bottom, double top) {
    /** All of it. */
    public static final Part WHOLE = new Part(0, 1, 0, 1);

    /** The {@code clipBoundary} of a Viewport (X3D 4.0, 35.4.4); all where it spans nothing. */
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
