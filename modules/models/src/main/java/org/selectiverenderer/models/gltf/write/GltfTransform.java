package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.databind.node.ObjectNode;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * The glTF nodes of a Transform. glTF has a translation, a rotation and a scale, in this order; X3D
 * has T C R SR S -SR -C (X3D 4.0, 10.4.4). One node is enough without a centre or scale
 * orientation, and with a centre if nothing moves; else there are up to three, one in another.
 *
 * @param outer index of the outermost node, which has the translation and the rotation
 * @param scaled index of the node that has the scale
 * @param inner index of the innermost node, which gets the children
 * @param centre the centre, which is part of the outermost node's translation
 */
record GltfTransform(int outer, int scaled, int inner, float[] centre) {

  /** Adds the nodes of a node that has the fields of a Transform. */
  static GltfTransform of(NodeView node, boolean animated, GltfDocument out) {
    float[] s = node.floats("scale");
    float[] c = node.floats("center");
    Vector3d centre = new Vector3d(c[0], c[1], c[2]);
    Vector3d at = vector(node.floats("translation")).add(centre);
    Quaterniond turn = rotation(node.floats("rotation"));
    Quaterniond oriented = rotation(node.floats("scaleOrientation"));
    boolean even = s[0] == s[1] && s[1] == s[2];
    boolean aligned = Math.abs(oriented.w) == 1 || even && !animated;
    ObjectNode outer = out.object();
    if (aligned && (!animated || centre.lengthSquared() == 0)) {
      Vector3d back = turn.transform(new Vector3d(centre).mul(s[0], s[1], s[2]));
      put(outer, at.sub(back), turn, vector(s));
      int only = out.add("nodes", outer);
      return new GltfTransform(only, only, only, c);
    }
    Vector3d one = new Vector3d(1);
    put(outer, at, turn, aligned ? vector(s) : one);
    int first = out.add("nodes", outer);
    ObjectNode last = out.object();
    if (aligned) {
      put(last, centre.negate(), new Quaterniond(), one);
      return new GltfTransform(first, first, child(outer, last, out), c);
    }
    ObjectNode middle = out.object();
    put(middle, new Vector3d(), oriented, vector(s));
    int scaled = child(outer, middle, out);
    Quaterniond back = new Quaterniond(oriented).conjugate();
    put(last, back.transform(centre.negate()), back, one);
    return new GltfTransform(first, scaled, child(middle, last, out), c);
  }

  /** Adds a node of a matrix without shear. */
  static GltfTransform of(Matrix4d matrix, GltfDocument out) {
    ObjectNode node = out.object();
    Vector3d scale = matrix.getScale(new Vector3d());
    put(
        node,
        matrix.getTranslation(new Vector3d()),
        matrix.getNormalizedRotation(new Quaterniond()),
        scale);
    int only = out.add("nodes", node);
    return new GltfTransform(only, only, only, new float[3]);
  }

  private static int child(ObjectNode parent, ObjectNode child, GltfDocument out) {
    int index = out.add("nodes", child);
    parent.putArray("children").add(index);
    return index;
  }

  /** Sets those properties of a node that differ from their defaults. */
  static void put(ObjectNode node, Vector3d at, Quaterniond turn, Vector3d scale) {
    if (at.lengthSquared() != 0) {
      GltfDocument.numbers(node, "translation", at.x, at.y, at.z);
    }
    if (turn.x != 0 || turn.y != 0 || turn.z != 0) {
      Quaterniond unit = turn.isFinite() ? turn.normalize(new Quaterniond()) : new Quaterniond();
      GltfDocument.numbers(node, "rotation", unit.x, unit.y, unit.z, unit.w);
    }
    if (scale.x != 1 || scale.y != 1 || scale.z != 1) {
      GltfDocument.numbers(node, "scale", scale.x, scale.y, scale.z);
    }
  }

  static Vector3d vector(float[] xyz) {
    return new Vector3d(xyz[0], xyz[1], xyz[2]);
  }

  /** Returns the rotation of an axis of any length, where 0 means no rotation, and an angle. */
  static Quaterniond rotation(float[] r) {
    Vector3d axis = new Vector3d(r[0], r[1], r[2]);
    double length = axis.length();
    return length > 0 && Double.isFinite(length) && r[3] != 0 && Float.isFinite(r[3])
        ? new Quaterniond().fromAxisAngleRad(axis.div(length), r[3])
        : new Quaterniond();
  }
}
