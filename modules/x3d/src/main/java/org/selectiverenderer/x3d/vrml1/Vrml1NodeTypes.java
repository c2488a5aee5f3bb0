package org.selectiverenderer.x3d.vrml1;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field;

/**
 * The node types of VRML 1.0 with their fields, and those of VRML97 that Castle Game Engine allows.
 * It tells what is not one of these.
 */
final class Vrml1NodeTypes {
  private static final String TABLE =
      """
      AsciiText string spacing justification width
      Background skyColor skyAngle groundColor groundAngle backUrl bottomUrl frontUrl leftUrl rightUrl topUrl
      Cone parts bottomRadius height
      Coordinate3 point
      Cube width height depth
      Cylinder parts radius height
      DirectionalLight on intensity color direction
      Fog color fogType visibilityRange
      FontStyle size family style
      Group
      IndexedFaceSet coordIndex materialIndex normalIndex textureCoordIndex
      IndexedLineSet coordIndex materialIndex normalIndex textureCoordIndex
      Info string
      LOD range center
      Material ambientColor diffuseColor specularColor emissiveColor shininess transparency
      MaterialBinding value
      MatrixTransform matrix
      NavigationInfo avatarSize headlight speed type visibilityLimit
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

  private final Set<String> told = new HashSet<>();
  private final ElementTreeBuilder document;
  private final Vrml1Values values;

  Vrml1NodeTypes(ElementTreeBuilder document, Vrml1Values values) {
    this.document = document;
    this.values = values;
    for (String line : TABLE.lines().toList()) {
      List<String> words = List.of(line.split(" "));
      fields.put(words.get(0), words.subList(1, words.size()));
    }
  }

  /** Returns the type of VRML 1.0 by which a node is read; null, which is told, if it has none. */
  @Nullable String type(Vrml1Node node) {
    String type = node.type();
    if (!known(type)) {
      Field ancestors = node.field("isA");
      String known = null;
      for (String word : ancestors == null ? new String[0] : words(ancestors)) {
        known = known == null && known(word) ? word : known;
      }
      if (known == null && told.add(type)) {
        String what = "the node type %s is not one of VRML 1.0; such nodes are left out";
        document.leftOut(node.start(), what.formatted(FieldTokenizer.quote(type)));
      }
      return known;
    }
    for (Map.Entry<String, Field> field : node.fields().entrySet()) {
      if (!has(type, field.getKey()) && told.add(type + " " + field.getKey())) {
        String what = "%s of VRML 1.0 has no field %s; it is left out";
        document.leftOut(
            field.getValue().at(),
            what.formatted(SpellingSuggester.one(type), FieldTokenizer.quote(field.getKey())));
      }
    }
    return type;
  }

  private String[] words(Field field) {
    return values.text(field).split("[\\s,\"]+");
  }

  /** Returns the names of the fields of a known type. */
  List<String> fields(String type) {
    return fields.getOrDefault(type, List.of());
  }

  private boolean known(String type) {
    return fields.containsKey(type);
  }

  /** Returns whether a known type has a field; all may declare theirs and their ancestors. */
  private boolean has(String type, String field) {
    return field.equals("fields") || field.equals("isA") || fields(type).contains(field);
  }
}
