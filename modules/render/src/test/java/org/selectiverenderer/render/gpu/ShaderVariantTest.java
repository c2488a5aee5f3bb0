package org.selectiverenderer.render.gpu;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Constructor;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class ShaderVariantTest {
  private static Object[] values() {
    return Arrays.stream(ShaderVariant.class.getRecordComponents())
        .map(component -> component.getType() == boolean.class ? (Object) false : List.of())
        .toArray();
  }

  private static ShaderVariant of(Object... values) throws ReflectiveOperationException {
    Class<?>[] types =
        Arrays.stream(ShaderVariant.class.getRecordComponents())
            .map(RecordComponent::getType)
            .toArray(Class<?>[]::new);
    Constructor<ShaderVariant> constructor = ShaderVariant.class.getDeclaredConstructor(types);
    return constructor.newInstance(values);
  }

  /** Its equals is written out, which leaves room for a component that is forgotten. */
  @Test
  void eachComponentTellsVariantsApart() throws ReflectiveOperationException {
    RecordComponent[] components = ShaderVariant.class.getRecordComponents();
    for (int i = 0; i < components.length; i++) {
      Object[] other = values();
      other[i] = components[i].getType() == boolean.class ? (Object) true : List.of("detail");
      assertThat(of(other)).as(components[i].getName()).isNotEqualTo(of(values()));
    }
    assertThat(of(values())).isEqualTo(of(values())).hasSameHashCodeAs(of(values()));
  }
}
