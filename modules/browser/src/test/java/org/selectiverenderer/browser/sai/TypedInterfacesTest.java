package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Array;
import java.lang.reflect.Method;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.web3d.x3d.sai.InvalidOperationTimingException;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DProtoInstance;

/**
 * Every node interface of the SAI's sub-packages, all of its methods, on a node of its type: the
 * naming rule of the SAI package serves all of them.
 */
class TypedInterfacesTest {
  private static final String BASE = X3DNode.class.getPackageName();

  static List<Class<?>> interfaces() throws IOException {
    try {
      Path here =
          Path.of(X3DNode.class.getProtectionDomain().getCodeSource().getLocation().toURI());
      if (Files.isDirectory(here)) {
        return in(here.resolve(BASE.replace('.', '/')));
      }
      try (FileSystem jar = FileSystems.newFileSystem(here)) {
        return in(jar.getPath(BASE.replace('.', '/')));
      }
    } catch (java.net.URISyntaxException e) {
      throw new IOException(e);
    }
  }

  private static List<Class<?>> in(Path base) throws IOException {
    try (Stream<Path> files = Files.walk(base, 2)) {
      return files
          .filter(file -> base.relativize(file).getNameCount() == 2)
          .map(file -> base.relativize(file).toString().replace('/', '.').replace('\\', '.'))
          .filter(name -> name.endsWith(".class") && !name.contains("package-info"))
          .<Class<?>>map(name -> load(BASE + "." + name.substring(0, name.length() - 6)))
          .filter(X3DNode.class::isAssignableFrom)
          .toList();
    }
  }

  private static Class<?> load(String name) {
    try {
      return Class.forName(name);
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void theInterfacesAreFound() throws IOException {
    assertThat(interfaces()).hasSizeGreaterThan(60);
  }

  @ParameterizedTest
  @MethodSource("interfaces")
  void everyMethodIsServed(Class<?> type) throws Exception {
    try (SaiFixture sai = new SaiFixture()) {
      X3DNode node = sai.make(type.getSimpleName());
      assertThat(node).isInstanceOf(type);
      for (Method method : type.getMethods()) {
        if (method.getName().startsWith("get") && method.getParameterCount() == 0) {
          method.invoke(node);
        }
      }
      for (Method method : type.getMethods()) {
        if (method.getName().startsWith("set") && writes(method)) {
          Object value = sample(sai, node, method);
          method.invoke(node, value);
          readBack(type, node, method, value);
        }
      }
    }
  }

  /** The overloads for instances of prototypes have no argument here, as there are none. */
  private static boolean writes(Method method) {
    return !method.getParameterTypes()[0].equals(X3DProtoInstance.class);
  }

  private static FieldDefinition target(SaiFixture sai, X3DNode node, String name) {
    NodeType type = sai.catalogue.get(node.getNodeName());
    String x = Character.toLowerCase(name.charAt(3)) + name.substring(4);
    return type.field(x)
        .filter(field -> field.access() != AccessType.OUTPUT_ONLY)
        .or(() -> type.field("set_" + x))
        .orElseThrow(() -> new AssertionError(type + " has no field for " + name));
  }

  private static Object sample(SaiFixture sai, X3DNode node, Method method) {
    FieldDefinition field = target(sai, node, method.getName());
    Class<?> wanted = method.getParameterTypes()[0];
    if (wanted.isArray()) {
      int length = Math.max(1, field.type().components()) * (field.type().multiple() ? 2 : 1);
      Object array = Array.newInstance(wanted.getComponentType(), length);
      for (int i = 0; i < length; i++) {
        Array.set(array, i, single(sai, field, wanted.getComponentType(), i));
      }
      return array;
    }
    return single(sai, field, wanted, 1);
  }

  private static Object single(SaiFixture sai, FieldDefinition field, Class<?> type, int i) {
    if (type == boolean.class) {
      return true;
    }
    if (type == int.class) {
      return i + 1;
    }
    if (type == float.class) {
      return (i + 1) * 0.25f;
    }
    if (type == double.class) {
      return (i + 1) * 0.125;
    }
    if (type == String.class) {
      return "text " + i;
    }
    NodeType accepted =
        sai.catalogue.all().stream()
            .filter(candidate -> field.nodeTypes().stream().anyMatch(candidate::is))
            .findFirst()
            .orElseThrow(() -> new AssertionError(field + " takes no node"));
    return sai.make(accepted.name());
  }

  private static void readBack(Class<?> type, X3DNode node, Method setter, Object written)
      throws Exception {
    String getter = "get" + setter.getName().substring(3);
    Method method =
        Arrays.stream(type.getMethods())
            .filter(candidate -> candidate.getName().equals(getter))
            .findFirst()
            .orElse(null);
    if (method == null) {
      return;
    }
    if (method.getParameterCount() == 0) {
      assertThat(method.invoke(node)).as(getter).isEqualTo(written);
      return;
    }
    Object read =
        Array.newInstance(
            method.getParameterTypes()[0].getComponentType(), Array.getLength(written));
    method.invoke(node, read);
    assertThat(read).as(getter).isEqualTo(written);
  }

  /** Every field of every node, by the interface of its type. */
  @Test
  void everyFieldOfEveryNodeTypeIsReadAndDescribed() {
    try (SaiFixture sai = new SaiFixture()) {
      for (NodeType type : sai.catalogue.all()) {
        X3DNode node = sai.make(type.name());
        assertThat(node.getFieldDefinitions()).hasSize(type.fields().size());
        for (FieldDefinition field : type.fields()) {
          X3DField described = node.getField(field.name());
          assertThat(described.getDefinition().getName()).isEqualTo(field.name());
          assertThat(described.getDefinition().getFieldTypeString()).isEqualTo(field.type().name());
          assertThat(described.isReadable()).isEqualTo(field.access() != AccessType.INPUT_ONLY);
        }
      }
    }
  }

  @Test
  void initializeOnlyFieldsAreWrittenBeforeTheNodeIsRealizedOnly() throws Exception {
    try (SaiFixture sai = new SaiFixture()) {
      var sensor = (org.web3d.x3d.sai.grouping.Group) sai.make("Group");
      sensor.setBboxSize(new float[] {1, 2, 3});
      float[] size = new float[3];
      sensor.getBboxSize(size);
      assertThat(size).containsExactly(1, 2, 3);
      assertThat(sensor.isRealized()).isFalse();
      sensor.realize();

      assertThat(sensor.isRealized()).isTrue();
      assertThatThrownBy(() -> sensor.setBboxSize(new float[] {4, 5, 6}))
          .isInstanceOf(InvalidOperationTimingException.class)
          .hasMessageContaining("bboxSize");
      sensor.getBboxSize(size);
      assertThat(size).containsExactly(1, 2, 3);
    }
  }

  @Test
  void addingANodeToASceneRealizesIt() {
    try (SaiFixture sai = new SaiFixture()) {
      X3DNode group = sai.make("Group");
      sai.scene().addRootNode(group);
      assertThat(group.isRealized()).isTrue();
    }
  }

  @Test
  void nodesOfAFileAreTypedAndAlwaysTheSameObject() {
    try (SaiFixture sai = SaiFixture.showing("<Switch DEF='S' whichChoice='1'/>")) {
      assertThat(sai.node("S")).isInstanceOf(org.web3d.x3d.sai.grouping.Switch.class);
      assertThat(sai.node("S")).isSameAs(sai.node("S")).isEqualTo(sai.scene().getRootNodes()[0]);
      assertThat(sai.node("S")).isNotEqualTo(sai.make("Switch")).isNotEqualTo(null);
      assertThat(Map.of(sai.node("S"), 1)).containsKey(sai.node("S"));
      assertThat(sai.node("S")).hasToString("Switch S");
    }
  }
}
