package org.selectiverenderer.render.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.awt.AWTException;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.window.InputEvent.ButtonInput;
import org.selectiverenderer.render.window.InputEvent.KeyInput;
import org.selectiverenderer.render.window.InputEvent.MotionInput;
import org.selectiverenderer.testing.ShowsWindows;

@ShowsWindows
@Timeout(value = 60, unit = TimeUnit.SECONDS)
class RenderWindowTest {
  /** Frames after which a test gives up waiting. */
  private static final int MOST = 20_000;

  /** Draws green frames and remembers what was called. */
  private static class Green implements WindowContent {
    final List<String> calls = new ArrayList<>();
    int frames;
    int color;
    FrameSize size = new FrameSize(0, 0, 0);

    @Override
    public void start(GL3 gl) {
      calls.add("start on " + Thread.currentThread().getName());
    }

    @Override
    public boolean step() {
      return frames < 3;
    }

    @Override
    public void draw(GL3 gl, FrameSize newSize) {
      frames++;
      size = newSize;
      gl.glClearColor(0, 1, 0, 1);
      gl.glClear(GL.GL_COLOR_BUFFER_BIT);
      color = Screenshot.read(gl, 1, 1).rgb(0, 0);
    }

    @Override
    public void stop(GL3 gl) {
      calls.add("stop on " + Thread.currentThread().getName());
    }
  }

  private static WindowOptions options() {
    return new WindowOptions("test", 320, 240, 0, false);
  }

  private static List<Thread> renderThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().equals("render"))
        .toList();
  }

  @Test
  void framesAreDrawnOnOneThreadUntilTheSourceEnds() throws InterruptedException {
    Green source = new Green();
    new RenderWindow(options(), source, event -> {}, List.of()).run();
    assertThat(source.frames).isEqualTo(3);
    assertThat(source.color).isEqualTo(0x00ff00);
    assertThat(source.size).isEqualTo(new FrameSize(320, 240, 1));
    assertThat(source.calls).containsExactly("start on render", "stop on render");
    assertThat(renderThreads()).isEmpty();
  }

  @Test
  void aWindowOfSeveralSamplesOpensAndAnotherAfterIt() throws InterruptedException {
    for (int round = 0; round < 2; round++) {
      Green source = new Green();
      new RenderWindow(
              new WindowOptions("test", 200, 100, 4, false), source, event -> {}, List.of())
          .run();
      assertThat(source.frames).isEqualTo(3);
    }
  }

  @Test
  void aFailureWhileDrawingEndsTheLoopAndReachesTheCaller() {
    Green source =
        new Green() {
          @Override
          public void draw(GL3 gl, FrameSize newSize) {
            throw new IllegalStateException("the world is gone");
          }
        };
    RenderWindow window = new RenderWindow(options(), source, event -> {}, List.of());
    assertThatThrownBy(window::run)
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("the world is gone");
    assertThat(source.calls).containsExactly("start on render", "stop on render");
    assertThat(renderThreads()).isEmpty();
  }

  @Test
  void aFailureInAStepReachesTheCaller() {
    Green source =
        new Green() {
          @Override
          public boolean step() {
            throw new IllegalArgumentException("no step");
          }
        };
    assertThatThrownBy(() -> new RenderWindow(options(), source, event -> {}, List.of()).run())
        .hasMessage("no step");
  }

  @Test
  void anotherThreadMayCloseIt() throws InterruptedException {
    Green source =
        new Green() {
          @Override
          public boolean step() {
            return true;
          }
        };
    RenderWindow window = new RenderWindow(options(), source, event -> {}, List.of());
    Thread closer = new Thread(window::close);
    closer.start();
    window.run();
    closer.join();
    assertThat(renderThreads()).isEmpty();
  }

  @Test
  void keysAndMouseReachTheListenerOnTheRenderThread() throws Exception {
    List<Object> heard = new ArrayList<>();
    List<String> threads = new ArrayList<>();
    Green source = new Typist(heard);
    new RenderWindow(
            options(),
            source,
            event -> {
              threads.add(Thread.currentThread().getName());
              heard.add(event);
            },
            List.of())
        .run();
    assertThat(heard)
        .anyMatch(e -> e instanceof KeyInput k && k.key() == KeyboardKey.W && k.pressed())
        .anyMatch(e -> e instanceof KeyInput k && k.key() == KeyboardKey.PAGE_UP && !k.pressed())
        .anyMatch(e -> e instanceof ButtonInput b && b.button() == 1 && b.pressed())
        .anyMatch(e -> e instanceof MotionInput m && m.dx() == 7 && m.dy() == 3);
    assertThat(threads).containsOnly("render");
  }

  /** Types and drags once the window is there; ends when it has heard the last of it. */
  private static final class Typist extends Green {
    private final Robot robot;
    private final List<Object> heard;

    Typist(List<Object> heard) throws AWTException {
      this.heard = heard;
      robot = new Robot();
    }

    @Override
    public boolean step() {
      if (frames == 5) {
        robot.mouseMove(100, 100);
        robot.keyPress(KeyEvent.VK_W);
        robot.keyRelease(KeyEvent.VK_W);
        robot.keyPress(KeyEvent.VK_PAGE_UP);
        robot.keyRelease(KeyEvent.VK_PAGE_UP);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseMove(107, 103);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        frames++;
      }
      boolean done =
          heard.stream().anyMatch(e -> e instanceof ButtonInput button && !button.pressed());
      return !done && frames < MOST;
    }
  }
}
