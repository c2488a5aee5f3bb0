package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import org.selectiverenderer.models.scene.Keyframes;

/**
 * Reads the values of an animation over time, as X3D's interpolators have them: linear between
 * keys. Steps have two keys at one time; cubic splines (glTF 2.0, appendix C) are sampled.
 */
final class AnimationSamplerReader {
  private static final int SAMPLES = 8;

  private AnimationSamplerReader() {}

  /**
   * Reads a sampler.
   *
   * @param size the numbers of a value
   * @throws IOException if it is damaged, with one sentence
   */
  static Keyframes read(JsonNode sampler, GltfAccessors accessors, int size) throws IOException {
    float[] times = accessors.floats(GltfFile.index(sampler, "input"));
    float[] values = accessors.floats(GltfFile.index(sampler, "output"));
    String interpolation = sampler.path("interpolation").asText("LINEAR");
    boolean cubic = interpolation.equals("CUBICSPLINE");
    if (size < 1
        || times.length == 0
        || values.length != (long) times.length * size * (cubic ? 3 : 1)) {
      throw new IOException("its times and values differ in number");
    }
    for (int i = 1; i < times.length; i++) {
      if (times[i] < times[i - 1]) {
        throw new IOException("its times decrease");
      }
    }
    return switch (interpolation) {
      case "STEP" -> stepped(times, values, size);
      case "CUBICSPLINE" -> sampled(times, values, size);
      default -> new Keyframes(times, values, size);
    };
  }

  private static Keyframes stepped(float[] times, float[] values, int size) {
    int count = 2 * times.length - 1;
    float[] keys = new float[count];
    float[] stepped = new float[Math.multiplyExact(count, size)];
    for (int i = 0; i < count; i++) {
      keys[i] = times[(i + 1) / 2];
      System.arraycopy(values, i / 2 * size, stepped, i * size, size);
    }
    return new Keyframes(keys, stepped, size);
  }

  private static Keyframes sampled(float[] times, float[] values, int size) {
    int count = (times.length - 1) * SAMPLES + 1;
    float[] keys = new float[count];
    float[] sampled = new float[Math.multiplyExact(count, size)];
    for (int i = 0; i < count; i++) {
      int key = Math.min(i / SAMPLES, Math.max(0, times.length - 2));
      int next = Math.min(key + 1, times.length - 1);
      double t = (double) (i - key * SAMPLES) / SAMPLES;
      double step = times[next] - times[key];
      keys[i] = (float) (times[key] + t * step);
      double t2 = t * t;
      double t3 = t2 * t;
      for (int k = 0; k < size; k++) {
        // an in-tangent, the value, an out-tangent for each key
        double from = values[(3 * key + 1) * size + k];
        double out = values[(3 * key + 2) * size + k];
        double to = values[(3 * next + 1) * size + k];
        double in = values[3 * next * size + k];
        sampled[i * size + k] =
            (float)
                ((2 * t3 - 3 * t2 + 1) * from
                    + step * (t3 - 2 * t2 + t) * out
                    + (-2 * t3 + 3 * t2) * to
                    + step * (t3 - t2) * in);
      }
    }
    return new Keyframes(keys, sampled, size);
  }
}
