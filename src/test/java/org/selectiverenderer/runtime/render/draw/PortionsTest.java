package org.selectiverenderer.runtime.render.draw;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL3;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class PortionsTest {
  private static final long PORTION = 36_000;

  private final List<String> calls = new ArrayList<>();
  private final GL3 gl =
      (GL3)
          Proxy.newProxyInstance(
              GL3.class.getClassLoader(),
              new Class<?>[] {GL3.class},
              (proxy, method, arguments) -> {
                calls.add(method.getName());
                return null;
              });

  @Test
  void aSoftwareRendererIsHandedEachPortion() {
    Portions portions = new Portions(true);
    for (int i = 0; i < 10; i++) {
      portions.drawn(gl, PORTION / 4);
    }
    assertThat(calls).containsExactly("glFlush", "glFlush");
    portions.end(gl);
    assertThat(calls).as("and what is left at the end").hasSize(3).containsOnly("glFlush");
  }

  @Test
  void nothingIsHandedOverTwice() {
    Portions portions = new Portions(true);
    portions.end(gl);
    assertThat(calls).isEmpty();
    portions.drawn(gl, PORTION);
    portions.end(gl);
    assertThat(calls).hasSize(1);
  }

  @Test
  void aGraphicsCardIsLeftAlone() {
    Portions portions = new Portions(false);
    portions.drawn(gl, 10 * PORTION);
    portions.end(gl);
    assertThat(calls).isEmpty();
  }
}
