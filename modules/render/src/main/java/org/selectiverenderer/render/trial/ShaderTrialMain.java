package org.selectiverenderer.render.trial;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.platform.ParentProcessWatcher;
import org.selectiverenderer.browser.instance.ShaderProgramSource.Stage;
import org.selectiverenderer.render.context.GlUnavailableException;
import org.selectiverenderer.render.context.OffscreenContext;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.glsl.GlslTranslator;
import org.selectiverenderer.render.gpu.CustomShaderProgram;

/**
 * Tries shader programs in a child process, until its standard input ends or nothing comes for some
 * seconds.
 */
public final class ShaderTrialMain {
  private static final int BUFFER = 1 << 16;

  /** Beyond the time after which the parent starts a new process. */
  private static final long MOST_IDLE = 2 * ShaderTrialProcess.IDLE.toNanos();

  /** The length of a message to the parent. */
  private static final int LONGEST = 1000;

  private volatile boolean busy;
  private volatile long idleSince;

  private ShaderTrialMain() {}

  /** Runs the child process. */
  public static void main(String[] arguments) throws IOException {
    ParentProcessWatcher.whenItEnds(() -> Runtime.getRuntime().halt(1));
    new ShaderTrialMain().run();
    Runtime.getRuntime().halt(0); // Without the shutdown of JOGL, in which a driver may hang.
  }

  private void run() throws IOException {
    // Not System.in and System.out, which libraries in Java could use.
    try (DataInputStream in =
            new DataInputStream(
                new BufferedInputStream(new FileInputStream(FileDescriptor.in), BUFFER));
        DataOutputStream out = new DataOutputStream(new FileOutputStream(FileDescriptor.out))) {
      serve(in, out);
    }
  }

  private void serve(DataInputStream in, DataOutputStream out) throws IOException {
    GL3 gl;
    try {
      gl = OffscreenContext.open().gl(); // Not closed: a driver may hang when it is to tidy up.
    } catch (GlUnavailableException e) {
      String message = String.valueOf(e.getMessage());
      out.writeByte(ShaderTrialProcess.UNABLE);
      out.writeUTF(message.substring(0, Math.min(message.length(), LONGEST)));
      return;
    }
    new OffscreenFramebuffer(gl, 1, 1, 0).bind(gl);
    int[] array = new int[1];
    gl.glGenVertexArrays(1, array, 0);
    gl.glBindVertexArray(array[0]);
    out.writeByte(ShaderTrialProcess.READY);
    endWhenIdle();
    while (in.read() == ShaderTrialProcess.PROGRAM) {
      busy = true;
      attempt(gl, in);
      idleSince = System.nanoTime();
      busy = false;
      out.writeByte(ShaderTrialProcess.TRIED);
    }
  }

  /** Ends this process when it is idle, so that it does not keep the driver's memory. */
  private void endWhenIdle() {
    idleSince = System.nanoTime();
    Thread watch =
        new Thread(
            () -> {
              try {
                while (busy || System.nanoTime() - idleSince < MOST_IDLE) {
                  Thread.sleep(ShaderTrialProcess.IDLE.toMillis() / 10);
                }
                Runtime.getRuntime().halt(0);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt(); // only an ending process interrupts it
              }
            },
            "idle-watch");
    watch.setDaemon(true);
    watch.start();
  }

  private static void attempt(GL3 gl, DataInputStream in) throws IOException {
    Map<String, Integer> attributes = new HashMap<>();
    for (int left = in.readInt(); left > 0; left--) {
      attributes.put(text(in), in.readInt());
    }
    List<GlslTranslator.Unit> units = new ArrayList<>();
    for (int left = in.readInt(); left > 0; left--) {
      Stage stage = Stage.values()[in.readByte()];
      units.add(new GlslTranslator.Unit(stage, units.size(), 0, text(in)));
    }
    CustomShaderProgram.of(gl, units, attributes)
        .program()
        .ifPresent(
            program -> {
              draw(gl, program);
              program.dispose(gl);
            });
  }

  private static String text(DataInputStream in) throws IOException {
    return new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8);
  }

  /**
   * Draws a point in the middle of a picture of one pixel, since some drivers compile a program
   * when it draws first, and since its loops run only then. Triangles are for geometry shaders.
   */
  private static void draw(GL3 gl, CustomShaderProgram program) {
    program.use(gl);
    for (CustomShaderProgram.Uniform uniform : program.uniforms()) {
      switch (uniform.type()) {
        case GL2ES2.GL_FLOAT_MAT3 -> program.set(gl, uniform, identity(3));
        case GL2ES2.GL_FLOAT_MAT4 -> program.set(gl, uniform, identity(4));
        default -> {} // Its own value.
      }
    }
    gl.glViewport(0, 0, 1, 1);
    gl.glDrawArrays(GL.GL_POINTS, 0, 1);
    gl.glDrawArrays(GL.GL_TRIANGLES, 0, 3);
    gl.glUseProgram(0);
    gl.glFinish();
    gl.glGetError(); // What cannot be drawn so, such as textures that lack, is no fault of it.
  }

  private static float[] identity(int size) {
    float[] matrix = new float[size * size];
    for (int i = 0; i < size; i++) {
      matrix[i * size + i] = 1;
    }
    return matrix;
  }
}
