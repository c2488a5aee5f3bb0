package org.selectiverenderer.browser.nodes.group;

import java.util.Optional;
import org.joml.Matrix4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.tessellate.TransformMatrix;

/**
 * Transform, CADPart, EspduTransform, HAnimJoint and HAnimSite: transforms its children by P' = T C
 * R SR S -SR -C P (X3D 4.0, 10.4.4).
 */
public class TransformNode extends GroupingNode {
  private final int translation;
  private final int center;
  private final int rotation;
  private final int scale;
  private final int scaleOrientation;

  public TransformNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    translation = type.indexOf("translation");
    center = type.indexOf("center");
    rotation = type.indexOf("rotation");
    scale = type.indexOf("scale");
    scaleOrientation = type.indexOf("scaleOrientation");
  }

  @Override
  public Optional<Matrix4d> placement() {
    return Optional.of(
        TransformMatrix.of(
            new Matrix4d(),
            (float[]) value(translation),
            (float[]) value(center),
            (float[]) value(rotation),
            (float[]) value(scale),
            (float[]) value(scaleOrientation)));
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
