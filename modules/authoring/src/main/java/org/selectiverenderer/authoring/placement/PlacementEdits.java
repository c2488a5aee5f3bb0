package org.selectiverenderer.authoring.placement;

import java.util.ArrayList;
import java.util.List;
import org.joml.AxisAngle4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.area.LocalCoordinateSystem;
import org.selectiverenderer.authoring.nodes.Reindenter;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Creates edits that give nodes another pose: they change only the fields of their Transforms that
 * differ, or put a new Transform around them. Numbers are rounded to a tenth of a millimetre in the
 * scene, and those that stay are written as they were.
 */
public final class PlacementEdits {
  private static final int ANGLE_DECIMALS = 6;
  private static final int AXIS_DECIMALS = 5;
  private static final double SAME_ANGLE = 1e-6;

  private final SceneDocument document;

  /** Creates the factory of edits of a document. */
  public PlacementEdits(SceneDocument document) {
    this.document = document;
  }

  /**
   * Gives nodes their poses.
   *
   * @param placed nodes with the poses that they get, none within another
   * @param name name of the undo step
   * @throws EditRejectedException if a pose is not finite, or the text comes from an entity
   */
  public Edit place(List<Placement> placed, String name) {
    List<TextEdit> changes = new ArrayList<>();
    placed.forEach(each -> changes.addAll(changes(each)));
    return new Edit(name, changes);
  }

  /**
   * Gives a node a value that an author typed, as it was typed.
   *
   * @param value as {@link PoseField#value} returns it
   * @param name name of the undo step
   * @return an empty edit if the value is there already, or needs no new Transform
   * @throws EditRejectedException if the text comes from an entity
   */
  public Edit set(Placement placed, PoseField field, String value, String name) {
    DocumentElement node = placed.node();
    SourceFormatter layout = document.layout();
    List<TextEdit> changes =
        placed
            .transform()
            .map(
                transform ->
                    field.written(placed).equals(value)
                        ? List.<TextEdit>of()
                        : List.of(layout.attribute(transform, field.field(), value)))
            .orElseGet(
                () ->
                    value.equals(field.usual())
                        ? List.of()
                        : List.of(
                            around(
                                node,
                                SourceFormatter.written(
                                    field.field(), value, layout.quote(node)))));
    return new Edit(name, changes);
  }

  private List<TextEdit> changes(Placement placed) {
    if (!placed.pose().matrix().isFinite()) {
      throw new EditRejectedException(
          placed.node() + " cannot be put there: its position would not be a number");
    }
    if (placed.transform().isPresent()) {
      return changed(placed.transform().get(), placed.pose(), placed.parent());
    }
    DocumentElement node = placed.node();
    String fields = fields(placed.pose(), placed.parent(), document.layout().quote(node));
    return fields.isEmpty() ? List.of() : List.of(around(node, fields));
  }

  private TextEdit around(DocumentElement node, String fields) {
    if (node.isReference()) {
      throw new EditRejectedException(
          node + " comes from an entity of the DOCTYPE; change it in the source");
    }
    return new TextEdit(
        node.start(),
        node.end(),
        Reindenter.wrapped(document, node, "<Transform" + fields + ">", "</Transform>"));
  }

  /** Returns the changes of a Transform's tag that give it another pose. */
  List<TextEdit> changed(DocumentElement transform, TransformPose pose, Matrix4dc parent) {
    TransformPose before = TransformPose.of(transform);
    SourceFormatter layout = document.layout();
    List<TextEdit> changes = new ArrayList<>();
    int decimals = decimals(parent);
    if (differs(before.translation(), pose.translation(), decimals)) {
      changes.add(
          layout.attribute(
              transform,
              "translation",
              numbers(pose.translation(), old(transform, "translation", 0), decimals)));
    }
    if (differs(before.rotation(), pose.rotation())) {
      changes.add(layout.attribute(transform, "rotation", rotation(pose.rotation(), transform)));
    }
    if (differsInScale(before.scale(), pose.scale())) {
      changes.add(
          layout.attribute(transform, "scale", scale(pose.scale(), old(transform, "scale", 1))));
    }
    if (differs(before.scaleOrientation(), pose.scaleOrientation())) {
      changes.add(
          layout.attribute(transform, "scaleOrientation", rotation(pose.scaleOrientation())));
    }
    return changes;
  }

  /** Returns the attributes of a new Transform with a pose; none for one that changes nothing. */
  static String fields(TransformPose pose, Matrix4dc parent, char quote) {
    StringBuilder text = new StringBuilder();
    int decimals = decimals(parent);
    if (differs(pose.translation(), new Vector3d(), decimals)) {
      append(text, "translation", numbers(pose.translation(), new float[3], decimals), quote);
    }
    if (differs(pose.center(), new Vector3d(), decimals)) {
      append(text, "center", numbers(pose.center(), new float[3], decimals), quote);
    }
    if (differs(pose.rotation(), new Quaterniond())) {
      append(text, "rotation", rotation(pose.rotation()), quote);
    }
    if (differsInScale(pose.scale(), new Vector3d(1))) {
      append(text, "scale", scale(pose.scale(), new float[] {1, 1, 1}), quote);
      if (differs(pose.scaleOrientation(), new Quaterniond())) {
        append(text, "scaleOrientation", rotation(pose.scaleOrientation()), quote);
      }
    }
    return text.toString();
  }

  private static void append(StringBuilder text, String name, String value, char quote) {
    text.append(SourceFormatter.written(name, value, quote));
  }

  private static float[] old(DocumentElement transform, String field, float otherwise) {
    return LocalCoordinateSystem.numbers(
        transform, field, FieldType.SFVec3f, otherwise, otherwise, otherwise);
  }

  /** The decimals by which a position is exact to a tenth of a millimetre of the scene. */
  private static int decimals(Matrix4dc parent) {
    Vector3d scale = parent.getScale(new Vector3d());
    double most = Math.max(scale.x, Math.max(scale.y, scale.z));
    int wanted = 4 + (int) Math.ceil(Math.log10(Math.max(1e-9, most)) - 1e-9);
    return Math.max(1, Math.min(9, wanted));
  }

  private static boolean differs(Vector3dc one, Vector3dc other, int decimals) {
    double least = 0.5 / DecimalFormatter.unit(decimals);
    return Math.abs(one.x() - other.x()) > least
        || Math.abs(one.y() - other.y()) > least
        || Math.abs(one.z() - other.z()) > least;
  }

  private static boolean differsInScale(Vector3dc one, Vector3dc other) {
    for (int k = 0; k < 3; k++) {
      if (Math.abs(one.get(k) - other.get(k)) > 1e-6 * Math.abs(other.get(k))) {
        return true;
      }
    }
    return false;
  }

  private static boolean differs(Quaterniondc one, Quaterniondc other) {
    Quaterniond between = one.mul(other.conjugate(new Quaterniond()), new Quaterniond());
    double sine = Math.sqrt(between.x * between.x + between.y * between.y + between.z * between.z);
    return 2 * Math.asin(Math.min(1, sine)) > SAME_ANGLE;
  }

  private static String numbers(Vector3dc wanted, float[] old, int decimals) {
    double least = 0.5 / DecimalFormatter.unit(decimals);
    StringBuilder text = new StringBuilder();
    for (int k = 0; k < 3; k++) {
      text.append(k == 0 ? "" : " ")
          .append(
              Math.abs(wanted.get(k) - old[k]) <= least
                  ? DecimalFormatter.shortest(old[k])
                  : DecimalFormatter.rounded(wanted.get(k), decimals));
    }
    return text.toString();
  }

  private static String scale(Vector3dc wanted, float[] old) {
    StringBuilder text = new StringBuilder();
    for (int k = 0; k < 3; k++) {
      double value = wanted.get(k);
      int decimals =
          (int) Math.max(0, Math.min(9, 4 - Math.floor(Math.log10(Math.abs(value) + 1e-9))));
      text.append(k == 0 ? "" : " ")
          .append(
              Math.abs(value - old[k]) <= 1e-6 * Math.abs(old[k])
                  ? DecimalFormatter.shortest(old[k])
                  : DecimalFormatter.rounded(value, decimals));
    }
    return text.toString();
  }

  /** Formats a rotation about the axis that a Transform has already, if it is about that. */
  private static String rotation(Quaterniondc wanted, DocumentElement transform) {
    float[] old =
        LocalCoordinateSystem.numbers(transform, "rotation", FieldType.SFRotation, 0, 0, 1, 0);
    AxisAngle4d turn = turn(wanted);
    double length = Math.hypot(Math.hypot(old[0], old[1]), old[2]);
    double along = (turn.x * old[0] + turn.y * old[1] + turn.z * old[2]) / length;
    if (old[3] == 0 || !(length > 0) || Math.abs(along) < 1 - 1e-9) {
      return rotation(wanted);
    }
    return DecimalFormatter.shortest(old[0])
        + " "
        + DecimalFormatter.shortest(old[1])
        + " "
        + DecimalFormatter.shortest(old[2])
        + " "
        + DecimalFormatter.rounded(along < 0 ? -turn.angle : turn.angle, ANGLE_DECIMALS);
  }

  private static String rotation(Quaterniondc wanted) {
    AxisAngle4d turn = turn(wanted);
    return DecimalFormatter.rounded(turn.x, AXIS_DECIMALS)
        + " "
        + DecimalFormatter.rounded(turn.y, AXIS_DECIMALS)
        + " "
        + DecimalFormatter.rounded(turn.z, AXIS_DECIMALS)
        + " "
        + DecimalFormatter.rounded(turn.angle, ANGLE_DECIMALS);
  }

  /** Returns axis and angle of at most half a turn, the axis mostly along the positive axes. */
  private static AxisAngle4d turn(Quaterniondc of) {
    double sign = of.w() < 0 ? -1 : 1;
    Vector3d axis = new Vector3d(of.x(), of.y(), of.z()).mul(sign);
    double sine = axis.length();
    double angle = 2 * Math.atan2(sine, of.w() * sign);
    if (angle < SAME_ANGLE) {
      return new AxisAngle4d(0, 0, 0, 1);
    }
    axis.div(sine);
    double largest = axis.get(axis.maxComponent());
    return largest < 0
        ? new AxisAngle4d(-angle, -axis.x, -axis.y, -axis.z)
        : new AxisAngle4d(angle, axis.x, axis.y, axis.z);
  }
}
