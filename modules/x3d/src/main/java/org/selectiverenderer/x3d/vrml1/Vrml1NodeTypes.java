package org.selectiverenderer.x3d.vrml1;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The node types of VRML 1.0 with their fields. */
final class Vrml1NodeTypes {
  private static final String TABLE =
      """
      AsciiText string spacing justification width
      Cone parts bottomRadius height
      Coordinate3 point
      Cube width height depth
      Cylinder parts radius height
      DirectionalLight on intensity color direction
      FontStyle size family style
      Group
      IndexedFaceSet coordIndex materialIndex normalIndex textureCoordIndex
      IndexedLineSet coordIndex materialIndex normalIndex textureCoordIndex
      Info string
      LOD range center
      Material ambientColor diffuseColor specularColor emissiveColor shininess transparency
      MaterialBinding value
      MatrixTransform matrix
      Normal vector
      NormalBinding value
      OrthographicCamera position orientation focalDistance height
      PerspectiveCamera position orientation focalDistance heightAngle
      PointLight on intensity color location
      PointSet startIndex numPoints
      Rotation rotation
      Scale scaleFactor
      Separator renderCulling
      ShapeHints vertexOrdering shapeType faceType creaseAngle
      Sphere radius
      SpotLight on intensity color location direction dropOffRate cutOffAngle
      Switch whichChild
      Texture2 filename image wrapS wrapT
      Texture2Transform translation rotation scaleFactor center
      TextureCoordinate2 point
      Transform translation rotation scaleFactor scaleOrientation center
      TransformSeparator
      Translation translation
      WWWAnchor name description map
      WWWInline name bboxSize bboxCenter
      """;

  private final Map<String, List<String>> fields = new HashMap<>();

  Vrml1NodeTypes() {
    for (String line : TABLE.lines().toList()) {
      List<String> words = List.of(line.split(" "));
      fields.put(words.get(0), words.subList(1, words.size()));
    }
  }

  boolean known(String type) {
    return fields.containsKey(type);
  }

  /** Returns whether a known type has a field; all may declare theirs and their ancestors. */
  boolean has(String type, String field) {
    return field.equals("fields")
        || field.equals("isA")
        || fields.getOrDefault(type, List.of()).contains(field);
  }
}
