package org.selectiverenderer.models.gltf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

class GltfAnimationTest extends GltfSceneTest {
  @Test
  void animationsBecomeInterpolatorsWithRoutes() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder()
                .triangle()
                .floats("SCALAR", 2, 0, 4)
                .floats("VEC3", 2, 0, 0, 0, 1, 2, 3),
            "{\"attributes\":{\"POSITION\":0}}",
            """
            ,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],
             "samplers":[{"input":1,"output":2,"interpolation":"STEP"}]}]""");

    assertThat(first(file, "TimeSensor").bool("loop")).isTrue();
    ParsedNode interpolator = first(file, "PositionInterpolator");
    assertThat(interpolator.floats("key")).containsExactly(0, 1, 1);
    assertThat(interpolator.floats("keyValue")).containsExactly(0, 0, 0, 0, 0, 0, 1, 2, 3);
    assertThat(file.routes()).hasSize(2);
  }

  @Test
  void animatedMorphTargetsMoveTheCoordinates() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder()
                .triangle()
                .floats("VEC3", 3, 0, 0, 1, 0, 0, 1, 0, 0, 1)
                .floats("SCALAR", 2, 0, 1)
                .floats("SCALAR", 2, 0, 2),
            "{\"attributes\":{\"POSITION\":0},\"targets\":[{\"POSITION\":1}]}",
            """
            ,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],
             "samplers":[{"input":2,"output":3}]}]""");

    assertThat(first(file, "CoordinateInterpolator").floats("keyValue"))
        .containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, 1, 0, 2, 0, 1, 2);
    assertThat(messages()).isEmpty();
  }

  @Test
  void animatedMorphTargetsTurnTheNormals() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder()
                .triangle()
                .floats("VEC3", 3, 0, 0, 1, 0, 0, 1, 0, 0, 1)
                .floats("VEC3", 3, 0, 1, -1, 0, 1, -1, 0, 1, 0)
                .floats("SCALAR", 2, 0, 1)
                .floats("SCALAR", 2, 0, 1),
            "{\"attributes\":{\"POSITION\":0,\"NORMAL\":1},"
                + "\"targets\":[{\"POSITION\":1,\"NORMAL\":2}]}",
            """
            ,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],
             "samplers":[{"input":3,"output":4}]}]""");

    float half = (float) Math.sqrt(0.5);
    assertThat(first(file, "NormalInterpolator").floats("keyValue"))
        .containsExactly(
            new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, half, half},
            within(1e-6f));
    assertThat(messages()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY})
  void anAnimationWithATimeThatIsNotFiniteIsLeftOut(float time) throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder()
                .triangle()
                .floats("SCALAR", 3, 0, 1, time)
                .floats("VEC3", 3, 0, 0, 0, 1, 2, 3, 4, 5, 6),
            "{\"attributes\":{\"POSITION\":0}}",
            """
            ,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],
             "samplers":[{"input":1,"output":2}]}]""");

    assertThat(all(file, "TimeSensor")).isEmpty();
    assertThat(messages())
        .containsExactly("animations[0].channels[0]: its times decrease; it is left out");
  }

  @Test
  void theCoordinatesOfAllAnimatedMorphTargetsHaveOneLimit() throws IOException {
    int keys = 400_000; // 3.6 million coordinates for a triangle
    float[] times = new float[keys];
    for (int i = 0; i < keys; i++) {
      times[i] = i;
    }
    X3dFile file =
        mesh(
            new GltfBuilder()
                .triangle()
                .floats("VEC3", 3, 0, 0, 1, 0, 0, 1, 0, 0, 1)
                .floats("SCALAR", keys, times)
                .floats("SCALAR", keys, new float[keys]),
            "{\"attributes\":{\"POSITION\":0},\"targets\":[{\"POSITION\":1}]}",
            """
            ,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}},
              {"sampler":0,"target":{"node":0,"path":"weights"}}],
             "samplers":[{"input":2,"output":3}]}]""");

    assertThat(all(file, "CoordinateInterpolator")).hasSize(1);
    assertThat(messages()).singleElement().asString().contains("need too many coordinates");
  }
}
