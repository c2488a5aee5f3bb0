package org.selectiverenderer.x3d.field;

import java.util.List;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * The field types of X3D (X3D 4.0, 5.3) and the Java types that represent them in this program.
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
 * <p>Arrays are shared, not copied, and must not be modified.
 */
public enum FieldType {
  /** True or false. */
  SFBool(Kind.BOOLEAN, 1, false),
  /** A whole number of 32 bits. */
  SFInt32(Kind.INT, 1, false),
  /** A number of 32 bits. */
  SFFloat(Kind.FLOAT, 1, false),
  /** A number of 64 bits. */
  SFDouble(Kind.DOUBLE, 1, false),
  /** Seconds. */
  SFTime(Kind.DOUBLE, 1, false),
  /** A text. */
  SFString(Kind.STRING, 1, false),
  /** A node or none. */
  SFNode(Kind.NODE, 1, false),
  /** A vector of two numbers of 32 bits. */
  SFVec2f(Kind.FLOAT, 2, false),
  /** A vector of three numbers of 32 bits. */
  SFVec3f(Kind.FLOAT, 3, false),
  /** A vector of four numbers of 32 bits. */
  SFVec4f(Kind.FLOAT, 4, false),
  /** A vector of two numbers of 64 bits. */
  SFVec2d(Kind.DOUBLE, 2, false),
  /** A vector of three numbers of 64 bits. */
  SFVec3d(Kind.DOUBLE, 3, false),
  /** A vector of four numbers of 64 bits. */
  SFVec4d(Kind.DOUBLE, 4, false),
  /** Red, green and blue, 0 to 1. */
  SFColor(Kind.FLOAT, 3, false),
  /** Red, green, blue and opacity, 0 to 1. */
  SFColorRGBA(Kind.FLOAT, 4, false),
  /** An axis and an angle in radians. */
  SFRotation(Kind.FLOAT, 4, false),
  /** A matrix of three rows, numbers of 32 bits. */
  SFMatrix3f(Kind.FLOAT, 9, false),
  /** A matrix of four rows, numbers of 32 bits. */
  SFMatrix4f(Kind.FLOAT, 16, false),
  /** A matrix of three rows, numbers of 64 bits. */
  SFMatrix3d(Kind.DOUBLE, 9, false),
  /** A matrix of four rows, numbers of 64 bits. */
  SFMatrix4d(Kind.DOUBLE, 16, false),
  /** Width, height, components, and a whole number for each pixel. */
  SFImage(Kind.INT, 0, false),
  /** Truth values. */
  MFBool(Kind.BOOLEAN, 1, true),
  /** Whole numbers. */
  MFInt32(Kind.INT, 1, true),
  /** Numbers of 32 bits. */
  MFFloat(Kind.FLOAT, 1, true),
  /** Numbers of 64 bits. */
  MFDouble(Kind.DOUBLE, 1, true),
  /** Points in time, in seconds. */
  MFTime(Kind.DOUBLE, 1, true),
  /** Texts. */
  MFString(Kind.STRING, 1, true),
  /** Nodes. */
  MFNode(Kind.NODE, 1, true),
  /** Vectors of two numbers of 32 bits. */
  MFVec2f(Kind.FLOAT, 2, true),
  /** Vectors of three numbers of 32 bits. */
  MFVec3f(Kind.FLOAT, 3, true),
  /** Vectors of four numbers of 32 bits. */
  MFVec4f(Kind.FLOAT, 4, true),
  /** Vectors of two numbers of 64 bits. */
  MFVec2d(Kind.DOUBLE, 2, true),
  /** Vectors of three numbers of 64 bits. */
  MFVec3d(Kind.DOUBLE, 3, true),
  /** Vectors of four numbers of 64 bits. */
  MFVec4d(Kind.DOUBLE, 4, true),
  /** Colours: red, green and blue of each. */
  MFColor(Kind.FLOAT, 3, true),
  /** Colours: red, green, blue and opacity of each. */
  MFColorRGBA(Kind.FLOAT, 4, true),
  /** Rotations: an axis and an angle in radians of each. */
  MFRotation(Kind.FLOAT, 4, true),
  /** Matrices of three rows, numbers of 32 bits. */
  MFMatrix3f(Kind.FLOAT, 9, true),
  /** Matrices of four rows, numbers of 32 bits. */
  MFMatrix4f(Kind.FLOAT, 16, true),
  /** Matrices of three rows, numbers of 64 bits. */
  MFMatrix3d(Kind.DOUBLE, 9, true),
  /** Matrices of four rows, numbers of 64 bits. */
  MFMatrix4d(Kind.DOUBLE, 16, true),
  /** Images, one after the other. */
  MFImage(Kind.INT, 0, true);

  /** The type of one component of a value. */
  public enum Kind {
    /** True or false. */
    BOOLEAN,
    /** A whole number of 32 bits. */
    INT,
    /** A number of 32 bits. */
    FLOAT,
    /** A number of 64 bits. */
    DOUBLE,
    /** A text. */
    STRING,
    /** A node. */
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

  /** Returns the type of one component. */
  public Kind kind() {
    return kind;
  }

  /** Returns the components per tuple: 3 for SFVec3f and MFVec3f; 0 for images of any length. */
  public int components() {
    return components;
  }

  /** Returns whether the type has any number of tuples (MF...). */
  public boolean multiple() {
    return multiple;
  }

  /** Returns whether the values are nodes. */
  public boolean isNode() {
    return kind == Kind.NODE;
  }

  /** Returns the default for fields without one in the standard: zero, empty or NULL. */
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
