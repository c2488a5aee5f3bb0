package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.lang.reflect.Array;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.web3d.x3d.sai.InvalidFieldValueException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.InvalidReadableFieldException;
import org.web3d.x3d.sai.InvalidWritableFieldException;
import org.web3d.x3d.sai.MFNode;
import org.web3d.x3d.sai.MFString;
import org.web3d.x3d.sai.MFVec3f;
import org.web3d.x3d.sai.MField;
import org.web3d.x3d.sai.SFBool;
import org.web3d.x3d.sai.SFImage;
import org.web3d.x3d.sai.SFNode;
import org.web3d.x3d.sai.SFVec3f;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DNode;

/** The interfaces of fields: SFInt32, MFString ... */
class SaiFieldValuesTest {
  private final SaiFixture sai = new SaiFixture();

  @AfterEach
  void close() {
    sai.close();
  }

  /** Field types that the SAI has interfaces for and the catalogue has inputOutput fields of. */
  static List<FieldType> types() {
    try (SaiFixture sai = new SaiFixture()) {
      return Arrays.stream(FieldType.values())
          .filter(type -> SaiTypeRegistry.find(type.name()).isPresent())
          .filter(type -> !type.isNode() && type.components() > 0)
          .filter(type -> find(sai, type) != null)
          .toList();
    }
  }

  private static X3DField find(SaiFixture sai, FieldType wanted) {
    for (NodeType type : sai.catalogue.all()) {
      for (FieldDefinition field : type.fields()) {
        if (field.type() == wanted && field.access() == AccessType.INPUT_OUTPUT) {
          return sai.make(type.name()).getField(field.name());
        }
      }
    }
    return null;
  }

  @Test
  void nearlyEveryFieldTypeIsCovered() {
    assertThat(types()).hasSizeGreaterThan(20).contains(FieldType.MFRotation, FieldType.SFTime);
  }

  private static Class<?> component(FieldType type) {
    return switch (type.kind()) {
      case BOOLEAN -> boolean.class;
      case INT -> int.class;
      case FLOAT -> float.class;
      case DOUBLE -> double.class;
      default -> String.class;
    };
  }

  private static Object number(FieldType type, int i) {
    return switch (type.kind()) {
      case BOOLEAN -> i % 2 == 0;
      case INT -> i;
      case FLOAT -> i * 0.5f;
      case DOUBLE -> i * 0.25;
      default -> "s" + i;
    };
  }

  /** Some tuples one after the other. */
  private static Object flat(FieldType type, int tuples) {
    Object array = Array.newInstance(component(type), tuples * type.components());
    for (int i = 0; i < Array.getLength(array); i++) {
      Array.set(array, i, number(type, i));
    }
    return array;
  }

  private static Object call(X3DField field, String name, Object... arguments) throws Exception {
    for (Method method : field.getClass().getInterfaces()[0].getMethods()) {
      if (method.getName().equals(name) && fits(method, arguments)) {
        try {
          return method.invoke(field, arguments);
        } catch (InvocationTargetException e) {
          throw (RuntimeException) e.getCause();
        }
      }
    }
    throw new AssertionError(field + " has no " + name + Arrays.toString(arguments));
  }

  private static boolean fits(Method method, Object... arguments) {
    if (method.getParameterCount() != arguments.length) {
      return false;
    }
    for (int i = 0; i < arguments.length; i++) {
      Class<?> type = method.getParameterTypes()[i];
      Class<?> given = arguments[i].getClass();
      boolean primitive = type.isPrimitive() && !given.isArray();
      if (!primitive && !type.isAssignableFrom(given)) {
        return false;
      }
    }
    return true;
  }

  private static Object all(X3DField field, FieldType type) throws Exception {
    Object array =
        Array.newInstance(component(type), ((MField) field).getSize() * type.components());
    call(field, "getValue", array);
    return array;
  }

  /** A tuple, or the value itself where it is one number. */
  private static Object tuple(FieldType type, int i) {
    if (type.components() == 1) {
      return number(type, i);
    }
    Object array = Array.newInstance(component(type), type.components());
    for (int c = 0; c < type.components(); c++) {
      Array.set(array, c, number(type, i));
    }
    return array;
  }

  private static Object at(X3DField field, FieldType type, int index) throws Exception {
    if (type.components() == 1) {
      return call(field, "get1Value", index);
    }
    Object array = Array.newInstance(component(type), type.components());
    call(field, "get1Value", index, array);
    return array;
  }

  @ParameterizedTest
  @MethodSource("types")
  void allMethodsOfAFieldDoWhatTheySay(FieldType type) throws Exception {
    X3DField field = find(sai, type);
    if (!type.multiple()) {
      if (type.components() == 1) {
        call(field, "setValue", number(type, 2));
        assertThat(call(field, "getValue")).isEqualTo(number(type, 2));
        return;
      }
      Object written = flat(type, 1);
      call(field, "setValue", written);
      Object read = Array.newInstance(component(type), type.components() + 1);
      call(field, "getValue", read);
      for (int i = 0; i < type.components(); i++) {
        assertThat(Array.get(read, i)).isEqualTo(Array.get(written, i));
      }
      return;
    }
    call(field, "setValue", 2, flat(type, 3));
    assertThat(all(field, type)).isEqualTo(flat(type, 2));
    call(field, "append", tuple(type, 7));
    call(field, "insertValue", 0, tuple(type, 8));
    call(field, "set1Value", 1, tuple(type, 9));
    assertThat(((MField) field).getSize()).isEqualTo(4);
    assertThat(at(field, type, 0)).isEqualTo(tuple(type, 8));
    assertThat(at(field, type, 1)).isEqualTo(tuple(type, 9));
    assertThat(at(field, type, 3)).isEqualTo(tuple(type, 7));
    call(field, "insertValue", 4, tuple(type, 5));
    assertThat(at(field, type, 4)).isEqualTo(tuple(type, 5));
    call(field, "removeValue", 4);
    call(field, "removeValue", 0);
    assertThat(at(field, type, 0)).isEqualTo(tuple(type, 9));
    Object before = all(field, type);
    for (int index : new int[] {-1, 3, 99}) {
      assertThatThrownBy(() -> at(field, type, index))
          .isInstanceOf(ArrayIndexOutOfBoundsException.class);
      assertThatThrownBy(() -> call(field, "removeValue", index))
          .isInstanceOf(ArrayIndexOutOfBoundsException.class);
      assertThatThrownBy(() -> call(field, "set1Value", index, tuple(type, 1)))
          .isInstanceOf(ArrayIndexOutOfBoundsException.class);
    }
    assertThatThrownBy(() -> call(field, "insertValue", 4, tuple(type, 1)))
        .isInstanceOf(ArrayIndexOutOfBoundsException.class);
    assertThatThrownBy(() -> call(field, "setValue", 4, flat(type, 3)))
        .isInstanceOf(InvalidFieldValueException.class)
        .hasMessageContaining("4 values of " + type);
    assertThatThrownBy(() -> call(field, "setValue", -1, flat(type, 3)))
        .isInstanceOf(InvalidFieldValueException.class);
    assertThat(all(field, type)).isEqualTo(before);
    call(field, "clear");
    assertThat(((MField) field).getSize()).isZero();
  }

  @Test
  void tuplesAreReadAndWrittenInRowsToo() {
    MFVec3f point = (MFVec3f) sai.make("Coordinate").getField("point");
    point.setValue(2, new float[][] {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
    float[][] rows = new float[2][3];
    point.getValue(rows);
    assertThat(rows).isDeepEqualTo(new float[][] {{1, 2, 3}, {4, 5, 6}});
    assertThatThrownBy(() -> point.setValue(2, new float[][] {{1, 2, 3}, {4, 5}}))
        .isInstanceOf(InvalidFieldValueException.class)
        .hasMessageContaining("row 1");
  }

  @Test
  void timesInMillisecondsBecomeSeconds() {
    SaiValueConverter values =
        new SaiValueConverter(new SaiContext(sai.world)); // no node type has an MFTime to write
    assertThat(values.first(FieldType.MFTime, 1, new long[] {2500, 1}))
        .isEqualTo(new double[] {2.5});
  }

  @Test
  void anArrayThatIsTooShortIsRefusedAndNothingChanges() {
    SFVec3f position = (SFVec3f) sai.make("Viewpoint").getField("position");
    assertThatThrownBy(() -> position.setValue(new float[2]))
        .isInstanceOf(InvalidFieldValueException.class)
        .hasMessageContaining("SFVec3f needs 3 components, not 2");
    assertThatThrownBy(() -> position.getValue(new float[2]))
        .isInstanceOf(ArrayIndexOutOfBoundsException.class);
    float[] value = new float[3];
    position.getValue(value);
    assertThat(value).containsExactly(0, 0, 10);
  }

  @Test
  void whatIsHandedInOrOutIsACopy() {
    SFVec3f position = (SFVec3f) sai.make("Viewpoint").getField("position");
    float[] mine = {1, 2, 3};
    position.setValue(mine);
    mine[0] = 9;
    float[] read = new float[3];
    position.getValue(read);
    read[1] = 9;
    position.getValue(read);
    assertThat(read).containsExactly(1, 2, 3);
  }

  @Test
  void nullIsNoValueButEmptiesANodeField() {
    X3DNode info = sai.make("WorldInfo");
    MFString lines = (MFString) info.getField("info");
    assertThatThrownBy(() -> lines.append(null)).isInstanceOf(InvalidFieldValueException.class);
    assertThatThrownBy(() -> lines.setValue(1, new String[1]))
        .isInstanceOf(InvalidFieldValueException.class);
    SFNode metadata = (SFNode) info.getField("metadata");
    X3DNode set = sai.make("MetadataSet");
    metadata.setValue(set);
    assertThat(metadata.getValue()).isSameAs(set);
    metadata.setValue(null);
    assertThat(metadata.getValue()).isNull();
  }

  @Test
  void nodeFieldsTakeTheNodesThatBelongThere() {
    X3DNode group = sai.make("Group");
    MFNode children = (MFNode) group.getField("children");
    X3DNode first = sai.make("Shape");
    X3DNode second = sai.make("Switch");
    children.append(first);
    children.insertValue(0, second);
    X3DNode[] read = new X3DNode[2];
    children.getValue(read);
    assertThat(read).containsExactly(second, first);
    children.set1Value(0, null);
    assertThat(children.getSize()).isEqualTo(1);
    children.removeValue(0);
    assertThatThrownBy(() -> children.get1Value(0))
        .isInstanceOf(ArrayIndexOutOfBoundsException.class);
    assertThatThrownBy(() -> children.append(sai.make("Box")))
        .isInstanceOf(InvalidNodeException.class)
        .hasMessageContaining("children takes")
        .hasMessageContaining("not Box");
    assertThatThrownBy(() -> ((SFNode) first.getField("geometry")).setValue(group))
        .isInstanceOf(InvalidNodeException.class);
    assertThat(children.getSize()).isZero();
  }

  @Test
  void fieldsThatOnlySendOrOnlyTakeSaySo() {
    X3DNode sensor = sai.make("ProximitySensor");
    SFBool isActive = (SFBool) sensor.getField("isActive");
    assertThat(isActive.isWritable()).isFalse();
    assertThatThrownBy(() -> isActive.setValue(true))
        .isInstanceOf(InvalidWritableFieldException.class)
        .hasMessageContaining("isActive of ProximitySensor is outputOnly");
    SFBool bind = (SFBool) sai.make("Viewpoint").getField("set_bind");
    assertThat(bind.isReadable()).isFalse();
    assertThat(bind.isWritable()).isTrue();
    assertThatThrownBy(bind::getValue).isInstanceOf(InvalidReadableFieldException.class);
  }

  @Test
  void twoObjectsOfAFieldAreEqual() {
    X3DNode group = sai.make("Group");
    X3DField children = group.getField("children");
    assertThat(children)
        .isEqualTo(group.getField("set_children"))
        .hasSameHashCodeAs(group.getField("children_changed"))
        .isNotEqualTo(group.getField("metadata"))
        .isNotEqualTo(sai.make("Group").getField("children"))
        .isNotEqualTo(null);
  }

  @Test
  void imagesGoInAndOutAsPixelsAndForTheAwt() {
    SFImage image = (SFImage) sai.make("PixelTexture").getField("image");
    image.setValue(2, 1, 3, new int[] {0xFF0000, 0x00FF00});
    assertThat(List.of(image.getWidth(), image.getHeight(), image.getComponents()))
        .containsExactly(2, 1, 3);
    int[] pixels = new int[2];
    image.getPixels(pixels);
    assertThat(pixels).containsExactly(0xFF0000, 0x00FF00);
    assertThat(((BufferedImage) image.getImage()).getRGB(1, 0)).isEqualTo(0xFF00FF00);

    BufferedImage drawn = new BufferedImage(1, 2, BufferedImage.TYPE_INT_RGB);
    drawn.setRGB(0, 0, Color.BLUE.getRGB());
    image.setImage(drawn);
    int[] two = new int[2];
    image.getPixels(two);
    assertThat(two).containsExactly(0x000000FF, 0x0000FFFF); // from below; black, then blue

    image.setValue(2, 2, 3, new int[4]);
    image.setSubImage(drawn, 1, 1, 0, 1, 1, 0);
    int[] four = new int[4];
    image.getPixels(four);
    assertThat(four).containsExactly(0, 0x0000FF, 0, 0);
    List<Runnable> wrong = new ArrayList<>();
    wrong.add(() -> image.setValue(2, 2, 3, new int[3]));
    wrong.add(() -> image.setValue(-1, 2, 3, new int[3]));
    wrong.add(() -> image.setValue(1, 1, 5, new int[3]));
    wrong.add(() -> image.setValue(1 << 16, 1 << 16, 3, new int[3]));
    wrong.add(() -> image.setSubImage(drawn, 2, 1, 0, 0, 0, 0));
    wrong.add(() -> image.setSubImage(drawn, 1, 1, 0, 0, 2, 0));
    wrong.add(() -> image.setSubImage(drawn, 1, 1, -1, 0, 0, 0));
    for (Runnable call : wrong) {
      assertThatThrownBy(call::run).isInstanceOf(InvalidFieldValueException.class);
    }
  }
}
