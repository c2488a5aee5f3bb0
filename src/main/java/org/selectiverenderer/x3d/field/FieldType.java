package org.selectiverenderer.x3d.field;

import java.util.List;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * The field types of X3D (X3D 4.0, 5.3) and the Java values that stand for them everywhere in this
 * program.
 *
 * <table>
 * <caption>Values</caption>
 * <tr><td>SFBool</td><td>{@code Boolean}</td></tr>
 * <tr><td>SFInt32</td><td>{@code Integer}</td></tr>
 * <tr><td>SFFloat</td><td>{@code Float}</td></tr>
 * <tr><td>SFDouble, SFTime</td><td>{@code Double}</td></tr>
 * <tr><td>SFString</td><td>{@code String}</td></tr>
 * <tr><td>SFVec2f ... SFMatrix4f, SFColor, SFRotation</td><td>{@code float[]}, one element per component</td></tr>
 * <tr><td>SFVec2d ...</td><td>{@code double[]}</td></tr>
 * <tr><td>SFImage</td><td>{@code int[]}: width, height, components, pixels</td></tr>
 * <tr><td>SFNode</td><td>{@link NodeView}, or null for NULL</td></tr>
 * <tr><td>MFBool, MFInt32, MFImage</td><td>{@code boolean[]}, {@code int[]}, {@code int[]}</td></tr>
 * <tr><td>MFFloat, MFVec3f, MFColor ...</td><td>{@code float[]}, the tuples one after the other</td></tr>
 * <tr><td>MFDouble, MFTime, MFVec3d ...</td><td>{@code double[]}, likewise</td></tr>
 * <tr><td>MFString</td><td>{@code String[]}</td></tr>
 * <tr><td>MFNode</td><td>{@code List<? extends NodeView>}, immutable</td></tr>
 * </table>
 *
 * <p>Arrays are shared, not copied: whoever is handed one must not write into it.
 */
public enum FieldType {
  SFBool(Kind.BOOLEAN, 1, false),
  SFInt32(Kind.INT, 1, false),
  SFFloat(Kind.FLOAT, 1, false),
  SFDouble(Kind.DOUBLE, 1, false),
  SFTime(Kind.DOUBLE, 1, false),
  SFString(Kind.STRING, 1, false),
  SFNode(Kind.NODE, 1, false),
  SFVec2f(Kind.FLOAT, 2, false),
  SFVec3f(Kind.FLOAT, 3, false),
  SFVec4f(Kind.FLOAT, 4, false),
  SFVec2d(Kind.DOUBLE, 2, false),
  SFVec3d(Kind.DOUBLE, 3, false),
  SFVec4d(Kind.DOUBLE, 4, false),
  SFColor(Kind.FLOAT, 3, false),
  SFColorRGBA(Kind.FLOAT, 4, false),
  SFRotation(Kind.FLOAT, 4, false),
  SFMatrix3f(Kind.FLOAT, 9, false),
  SFMatrix4f(Kind.FLOAT, 16, false),
  SFMatrix3d(Kind.DOUBLE, 9, false),
  SFMatrix4d(Kind.DOUBLE, 16, false),
  SFImage(Kind.INT, 0, false),
  MFBool(Kind.BOOLEAN, 1, true),
  MFInt32(Kind.INT, 1, true),
  MFFloat(Kind.FLOAT, 1, true),
  MFDouble(Kind.DOUBLE, 1, true),
  MFTime(Kind.DOUBLE, 1, true),
  MFString(Kind.STRING, 1, true),
  MFNode(Kind.NODE, 1, true),
  MFVec2f(Kind.FLOAT, 2, true),
  MFVec3f(Kind.FLOAT, 3, true),
  MFVec4f(Kind.FLOAT, 4, true),
  MFVec2d(Kind.DOUBLE, 2, true),
  MFVec3d(Kind.DOUBLE, 3, true),
  MFVec4d(Kind.DOUBLE, 4, true),
  MFColor(Kind.FLOAT, 3, true),
  MFColorRGBA(Kind.FLOAT, 4, true),
  MFRotation(Kind.FLOAT, 4, true),
  MFMatrix3f(Kind.FLOAT, 9, true),
  MFMatrix4f(Kind.FLOAT, 16, true),
  MFMatrix3d(Kind.DOUBLE, 9, true),
  MFMatrix4d(Kind.DOUBLE, 16, true),
  MFImage(Kind.INT, 0, true);

  /** What one component of a value is. */
  public enum Kind {
    BOOLEAN,
    INT,
    FLOAT,
    DOUBLE,
    STRING,
    NODE
  }

  private final Kind kind;
  private final int components;
  private final boolean multiple;

  FieldType(Kind kind, int components, boolean multiple) {
    this.kind = kind;
    this.components = components;
    this.multiple = multiple;
  }

  public Kind kind() {
    return kind;
  }

  /** Components of one tuple: 3 for SFVec3f and MFVec3f; 0 for images, whose length varies. */
  public int components() {
    return components;
  }

  /** Whether the type holds any number of tuples (MF...). */
  public boolean multiple() {
    return multiple;
  }

  /** Whether the value consists of nodes. */
  public boolean isNode() {
    return kind == Kind.NODE;
  }

  /** The value of a field of this type whose default the standard leaves out: zero, empty, NULL. */
  public Object zero() {
    return switch (kind) {
      case BOOLEAN -> multiple ? new boolean[0] : Boolean.FALSE;
      case INT ->
          this == SFImage ? new int[3] : multiple ? new int[0] : (Object) Integer.valueOf(0);
      case FLOAT ->
          multiple
              ? new float[0]
              : components == 1 ? (Object) Float.valueOf(0) : zeroFloats(components);
      case DOUBLE ->
          multiple
              ? new double[0]
              : components == 1 ? (Object) Double.valueOf(0) : new double[components];
      case STRING -> multiple ? new String[0] : "";
      case NODE -> multiple ? List.of() : null;
    };
  }

  private float[] zeroFloats(int length) {
    float[] value = new float[length];
    if (this == SFRotation) {
      value[2] = 1;
    }
    return value;
  }
}
