package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.web3d.x3d.sai.X3DNode;

/**
 * The node interfaces are written by hand, for what their comments say of each field; that they
 * have the methods of the node table is held here. They differ where the thesis's browser does: in
 * fields that came with X3D 4.0 or are of the draft of 4.1, and in few that it forgot.
 */
class NodeInterfacesFollowTheTableTest {
  private static final String DIFFERENCES =
      """
      Anchor is without autoRefresh autoRefreshTimeLimit bboxDisplay load visible
      Appearance is without acousticProperties alphaCutoff alphaMode backMaterial \
      pointProperties shaders
      Billboard is without bboxDisplay visible
      Collision is without bboxDisplay description visible
      DirectionalLight is without shadowIntensity shadows
      ElevationGrid is without attrib fogCoord
      Group is without bboxDisplay visible
      ImageTexture is without autoRefresh autoRefreshTimeLimit description load
      IndexedFaceSet is without tangent
      IndexedLineSet is without attrib fogCoord normal
      IndexedTriangleFanSet is without tangent
      IndexedTriangleSet is without tangent
      IndexedTriangleStripSet is without tangent
      Inline is without autoRefresh autoRefreshTimeLimit bboxDisplay description global \
      visible
      LOD is without bboxDisplay visible
      LineSet is without attrib fogCoord normal
      Material is without ambientTexture ambientTextureMapping diffuseTexture \
      diffuseTextureMapping emissiveTexture emissiveTextureMapping normalScale normalTexture \
      normalTextureMapping occlusionStrength occlusionTexture occlusionTextureMapping \
      shininessTexture shininessTextureMapping specularTexture specularTextureMapping
      NavigationInfo is without transitionComplete transitionTime
      PixelTexture is without description image
      PointLight is without shadowIntensity shadows
      PointSet is without attrib fogCoord normal
      ProximitySensor is without description
      Shape is without bboxDisplay castShadow visible
      SpotLight is without shadowIntensity shadows
      StaticGroup is without bboxDisplay visible
      Switch is without bboxDisplay visible
      Text is without lineBounds origin textBounds
      TextureCoordinate is without mapping
      TextureTransform is without mapping
      TimeSensor is without description
      Transform is without bboxDisplay visible
      TriangleFanSet is without tangent
      TriangleSet is without tangent
      TriangleStripSet is without tangent
      Viewpoint is without centerOfRotation farDistance navigationInfo nearDistance viewAll
      Viewpoint lacks void getOrientation(float[])
      VisibilitySensor is without description
      """;

  @Test
  void theInterfacesDifferFromTheTableWhereListedOnly() throws IOException {
    NodeCatalogue catalogue = NodeCatalogue.load();
    List<String> differences = new ArrayList<>();
    for (Class<?> type : TypedInterfacesTest.interfaces()) {
      differences.addAll(differences(type, catalogue.get(type.getSimpleName())));
    }
    assertThat(differences).containsExactlyInAnyOrderElementsOf(DIFFERENCES.lines().toList());
  }

  @Test
  void theInterfacesExtendTheAbstractTypesOfTheTable() throws IOException {
    NodeCatalogue catalogue = NodeCatalogue.load();
    for (Class<?> type : TypedInterfacesTest.interfaces()) {
      NodeType node = catalogue.get(type.getSimpleName());
      assertThat(type.getPackageName()).endsWith("." + node.component().toLowerCase(Locale.ROOT));
      assertThat(type.getInterfaces())
          .as(node.name())
          .allMatch(extended -> node.is(extended.getSimpleName()));
    }
  }

  private static List<String> differences(Class<?> type, NodeType node) {
    Set<String> found = methods(type);
    List<String> differences = new ArrayList<>();
    List<String> without = new ArrayList<>();
    methods(node)
        .forEach(
            (field, expected) -> {
              Set<String> missing = new TreeSet<>(expected);
              missing.removeAll(found);
              if (missing.equals(expected)) {
                without.add(field);
              } else {
                missing.forEach(method -> differences.add(node.name() + " lacks " + method));
              }
              found.removeAll(expected);
            });
    found.forEach(method -> differences.add(node.name() + " adds " + method));
    if (!without.isEmpty()) {
      differences.add(node.name() + " is without " + String.join(" ", without));
    }
    return differences;
  }

  /** What an interface has; the types of node that a setter is overloaded for count as one. */
  private static Set<String> methods(Class<?> type) {
    return Stream.of(type.getMethods())
        .filter(method -> !method.getDeclaringClass().equals(X3DNode.class))
        .map(NodeInterfacesFollowTheTableTest::signature)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static String signature(Method method) {
    return Stream.of(method.getParameterTypes())
        .map(parameter -> parameter.getSimpleName().replaceFirst("^X3D\\w+", "X3DNode"))
        .collect(
            Collectors.joining(
                ", ", method.getReturnType().getSimpleName() + " " + method.getName() + "(", ")"));
  }

  /** The methods that the naming rule of the SAI package gives, by the name of their field. */
  private static Map<String, Set<String>> methods(NodeType node) {
    Map<String, Set<String>> methods = new TreeMap<>();
    for (FieldDefinition field : node.fields()) {
      if (!field.name().equals("metadata")) { // X3DNode has it.
        String name = field.name().replaceFirst("^set_", "").replaceFirst("_changed$", "");
        methods.computeIfAbsent(name, first -> new TreeSet<>()).addAll(methods(name, field));
      }
    }
    return methods;
  }

  private static List<String> methods(String name, FieldDefinition field) {
    String x = Character.toUpperCase(name.charAt(0)) + name.substring(1);
    String java = java(field.type());
    List<String> methods = new ArrayList<>();
    if (field.access() != AccessType.INPUT_ONLY) {
      methods.add(
          java.endsWith("[]") ? "void get" + x + "(" + java + ")" : java + " get" + x + "()");
      if (field.type().multiple()) {
        methods.add("int getNum" + x + "()");
      }
    }
    if (field.access() != AccessType.OUTPUT_ONLY) {
      methods.add("void " + (name.endsWith("Children") ? name : "set" + x) + "(" + java + ")");
    }
    return methods;
  }

  private static String java(FieldType type) {
    String single =
        switch (type.kind()) {
          case BOOLEAN -> "boolean";
          case INT -> "int";
          case FLOAT -> "float";
          case DOUBLE -> "double";
          case STRING -> "String";
          case NODE -> "X3DNode";
        };
    return type.multiple() || type.components() != 1 ? single + "[]" : single;
  }
}
