package org.selectiverenderer.runtime.nodes;

import java.util.Optional;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeType;

/** Transform and CADPart: places its children, P' = T C R SR S -SR -C P (X3D 4.0, 10.4.4). */
public final class TransformNode extends GroupingNode {
  private final int translation;
  private final int center;
  private final int rotation;
  private final int scale;
  private final int scaleOrientation;

  public TransformNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    translation = type.indexOf("translation");
    center = type.indexOf("center");
    rotation = type.indexOf("rotation");
    scale = type.indexOf("scale");
    scaleOrientation = type.indexOf("scaleOrientation");
  }

  @Override
  public Optional<Matrix4d> placement() {
    float[] t = (float[]) value(translation);
    float[] c = (float[]) value(center);
    float[] r = (float[]) value(rotation);
    float[] s = (float[]) value(scale);
    float[] sr = (float[]) value(scaleOrientation);
    Matrix4d matrix =
        new Matrix4d().translate(t[0] + (double) c[0], t[1] + (double) c[1], t[2] + (double) c[2]);
    rotate(matrix, r, 1);
    rotate(matrix, sr, 1);
    matrix.scale(s[0], s[1], s[2]);
    rotate(matrix, sr, -1);
    return Optional.of(matrix.translate(-(double) c[0], -(double) c[1], -(double) c[2]));
  }

  private static void rotate(Matrix4d matrix, float[] r, int sign) {
    double length = Math.sqrt(r[0] * (double) r[0] + r[1] * (double) r[1] + r[2] * (double) r[2]);
    if (length > 0 && r[3] != 0) {
      matrix.rotate(sign * (double) r[3], r[0] / length, r[1] / length, r[2] / length);
    }
  }

  @Override
  public Effect effectOf(int field) {
    boolean moves =
        field == translation
            || field == center
            || field == rotation
            || field == scale
            || field == scaleOrientation;
    return moves ? Effect.PLACEMENT : super.effectOf(field);
  }
}
