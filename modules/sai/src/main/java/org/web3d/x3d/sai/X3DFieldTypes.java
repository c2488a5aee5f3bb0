package org.web3d.x3d.sai;

/**
 * The access types and field types that {@link X3DFieldDefinition} tells. The numbers are those of
 * the standard; types that came after the binding (X3D 3.1 and later vectors of four and matrices)
 * have none here, {@link X3DFieldDefinition#getFieldTypeString()} names them.
 */
public interface X3DFieldTypes {
  /** Access: receives events, holds no value. */
  int INPUT_ONLY = 1;

  /** Access: holds a value that is fixed once the node is realized. */
  int INITIALIZE_ONLY = 2;

  /** Access: holds a value, receives and sends events. */
  int INPUT_OUTPUT = 3;

  /** Access: sends events; its value is the last one sent. */
  int OUTPUT_ONLY = 4;

  /** {@link SFBool}. */
  int SFBOOL = 1;

  /** {@link MFBool}. */
  int MFBOOL = 2;

  /** {@link MFInt32}. */
  int MFINT32 = 3;

  /** {@link SFInt32}. */
  int SFINT32 = 4;

  /** Reserved by the binding; no field of X3D is of this type. */
  int SFLONG = 5;

  /** Reserved by the binding; no field of X3D is of this type. */
  int MFLONG = 6;

  /** {@link SFFloat}. */
  int SFFLOAT = 7;

  /** {@link MFFloat}. */
  int MFFLOAT = 8;

  /** {@link SFDouble}. */
  int SFDOUBLE = 9;

  /** {@link MFDouble}. */
  int MFDOUBLE = 10;

  /** {@link SFTime}. */
  int SFTIME = 11;

  /** {@link MFTime}. */
  int MFTIME = 12;

  /** {@link SFNode}. */
  int SFNODE = 13;

  /** {@link MFNode}. */
  int MFNODE = 14;

  /** {@link SFVec2f}. */
  int SFVEC2F = 15;

  /** {@link MFVec2f}. */
  int MFVEC2F = 16;

  /** {@link SFVec2d}. */
  int SFVEC2D = 17;

  /** {@link MFVec2d}. */
  int MFVEC2D = 18;

  /** {@link SFVec3f}. */
  int SFVEC3F = 19;

  /** {@link MFVec3f}. */
  int MFVEC3F = 20;

  /** {@link SFVec3d}. */
  int SFVEC3D = 21;

  /** {@link MFVec3d}. */
  int MFVEC3D = 22;

  /** {@link MFRotation}. */
  int MFROTATION = 23;

  /** {@link SFRotation}. */
  int SFROTATION = 24;

  /** {@link MFColor}. */
  int MFCOLOR = 25;

  /** {@link SFColor}. */
  int SFCOLOR = 26;

  /** {@link MFColorRGBA}. */
  int MFCOLORRGBA = 27;

  /** {@link SFColorRGBA}. */
  int SFCOLORRGBA = 28;

  /** {@link SFImage}. */
  int SFIMAGE = 29;

  /** {@link MFImage}. */
  int MFIMAGE = 30;

  /** {@link SFString}. */
  int SFSTRING = 31;

  /** {@link MFString}. */
  int MFSTRING = 32;
}
