package org.selectiverenderer.render.gpu;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

/**
 * Loads the application's shader sources and resolves their includes. Each resource is read once,
 * however many programs are made of it. For one thread.
 */
final class ShaderSourceLoader {
  private static final String FOLDER = "/org/selectiverenderer/render/";
  private static final String INCLUDE = "#include ";

  private final Map<String, String> texts = new HashMap<>();

  /**
   * Returns a shader source whose lines {@code #include other.glsl} are replaced by the texts of
   * these resources.
   *
   * @param resource such as {@code shape.vert.glsl}
   */
  String of(String resource) {
    String known = texts.get(resource);
    if (known == null) {
      known = whole(read(resource));
      texts.put(resource, known);
    }
    return known;
  }

  private String whole(String text) {
    StringBuilder whole = new StringBuilder();
    int done = 0;
    for (int at = next(text, 0); at >= 0; at = next(text, done)) {
      int end = text.indexOf('\n', at);
      int stop = end < 0 ? text.length() : end;
      whole.append(text, done, at).append(of(text.substring(at + INCLUDE.length(), stop)));
      done = stop;
    }
    return whole.append(text, done, text.length()).toString();
  }

  /** Returns the offset of the next include line; -1 if there is none. */
  private static int next(String text, int from) {
    int at = text.indexOf(INCLUDE, from);
    while (at > 0 && text.charAt(at - 1) != '\n') {
      at = text.indexOf(INCLUDE, at + 1);
    }
    return at;
  }

  private static String read(String resource) {
    try (InputStream in = ShaderSourceLoader.class.getResourceAsStream(FOLDER + resource)) {
      if (in == null) {
        throw new IllegalStateException("the program was built without its shader " + resource);
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException("the shader " + resource + " cannot be read", e);
    }
  }
}
