package org.selectiverenderer.render.draw;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.GL3;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class FrameFlusherTest {
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

  private void draw(FrameFlusher portions, long indices, int calls) {
    portions.begin(indices);
    for (int i = 0; i < calls; i++) {
      portions.drawn(gl, indices / calls);
    }
  }

  @Test
  void aSoftwareRendererIsHandedEachPortionOfALargeFrame() {
    FrameFlusher portions = new FrameFlusher(true);
    draw(portions, 5 * FrameFlusher.MOST / 2, 10);
    assertThat(calls).containsExactly("glFlush", "glFlush");
    portions.end(gl);
    assertThat(calls).as("and what is left at the end").hasSize(3).containsOnly("glFlush");
  }

  @Test
  void aSmallerFrameIsHandedOverInHalves() {
    FrameFlusher portions = new FrameFlusher(true);
    draw(portions, FrameFlusher.LEAST, 9);
    assertThat(calls).hasSize(1);
    portions.end(gl);
    assertThat(calls).hasSize(2);
  }

  @Test
  void aSmallFrameIsHandedOverAtItsEnd() {
    FrameFlusher portions = new FrameFlusher(true);
    draw(portions, FrameFlusher.LEAST - 1, 3);
    assertThat(calls).isEmpty();
    portions.end(gl);
    portions.end(gl);
    assertThat(calls).as("once").hasSize(1);
  }

  @Test
  void aGraphicsCardIsLeftAlone() {
    FrameFlusher portions = new FrameFlusher(false);
    draw(portions, 10 * FrameFlusher.MOST, 20);
    portions.end(gl);
    assertThat(calls).isEmpty();
  }
}
