package org.web3d.x3d.sai;

/**
 * The abstract node types that {@link X3DNode#getNodeType()} tells, by the names and numbers of the
 * standard. A type without a number here (those of X3D 3.1 and later) is not told.
 */
public interface X3DNodeTypes {
  /** The type {@code X3DBoundedObject}. */
  int X3DBoundedObject = 1;

  /** The type {@code X3DMetadataObject}. */
  int X3DMetadataObject = 2;

  /** The type {@code X3DUrlObject}. */
  int X3DUrlObject = 3;

  /** The type {@code X3DAppearanceNode}. */
  int X3DAppearanceNode = 10;

  /** The type {@code X3DAppearanceChildNode}. */
  int X3DAppearanceChildNode = 11;

  /** The type {@code X3DMaterialNode}. */
  int X3DMaterialNode = 12;

  /** The type {@code X3DTextureNode}. */
  int X3DTextureNode = 13;

  /** The type {@code X3DTexture2DNode}. */
  int X3DTexture2DNode = 14;

  /** The type {@code X3DTextureTransformNode}. */
  int X3DTextureTransformNode = 16;

  /** The type {@code X3DTextureTransform2DNode}. */
  int X3DTextureTransform2DNode = 17;

  /** The type {@code X3DGeometryNode}. */
  int X3DGeometryNode = 18;

  /** The type {@code X3DGeometricPropertyNode}. */
  int X3DGeometricPropertyNode = 19;

  /** The type {@code X3DParametricGeometryNode}. */
  int X3DParametricGeometryNode = 20;

  /** The type {@code X3DNurbsSurfaceGeometryNode}. */
  int X3DNurbsSurfaceGeometryNode = 21;

  /** The type {@code X3DColorNode}. */
  int X3DColorNode = 22;

  /** The type {@code X3DCoordinateNode}. */
  int X3DCoordinateNode = 23;

  /** The type {@code X3DNormalNode}. */
  int X3DNormalNode = 24;

  /** The type {@code X3DTextureCoordinateNode}. */
  int X3DTextureCoordinateNode = 25;

  /** The type {@code X3DFontStyleNode}. */
  int X3DFontStyleNode = 26;

  /** The type {@code X3DProtoInstance}. */
  int X3DProtoInstance = 27;

  /** The type {@code X3DChildNode}. */
  int X3DChildNode = 28;

  /** The type {@code X3DBindableNode}. */
  int X3DBindableNode = 29;

  /** The type {@code X3DBackgroundNode}. */
  int X3DBackgroundNode = 30;

  /** The type {@code X3DGroupingNode}. */
  int X3DGroupingNode = 31;

  /** The type {@code X3DShapeNode}. */
  int X3DShapeNode = 32;

  /** The type {@code X3DInterpolatorNode}. */
  int X3DInterpolatorNode = 33;

  /** The type {@code X3DLightNode}. */
  int X3DLightNode = 34;

  /** The type {@code X3DScriptNode}. */
  int X3DScriptNode = 35;

  /** The type {@code X3DSensorNode}. */
  int X3DSensorNode = 36;

  /** The type {@code X3DEnvironmentalSensorNode}. */
  int X3DEnvironmentalSensorNode = 37;

  /** The type {@code X3DKeyDeviceSensorNode}. */
  int X3DKeyDeviceSensorNode = 38;

  /** The type {@code X3DNetworkSensorNode}. */
  int X3DNetworkSensorNode = 39;

  /** The type {@code X3DPointingDeviceSensorNode}. */
  int X3DPointingDeviceSensorNode = 40;

  /** The type {@code X3DDragSensorNode}. */
  int X3DDragSensorNode = 41;

  /** The type {@code X3DTouchSensorNode}. */
  int X3DTouchSensorNode = 42;

  /** The type {@code X3DSequencerNode}. */
  int X3DSequencerNode = 43;

  /** The type {@code X3DTimeDependentNode}. */
  int X3DTimeDependentNode = 44;

  /** The type {@code X3DSoundSourceNode}. */
  int X3DSoundSourceNode = 45;

  /** The type {@code X3DTriggerNode}. */
  int X3DTriggerNode = 46;

  /** The type {@code X3DInfoNode}. */
  int X3DInfoNode = 47;

  /** The type {@code X3DNurbsControlCurveNode}. */
  int X3DNurbsControlCurveNode = 48;
}
