package org.selectiverenderer.radiosity.scene;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class MemoryEstimatorTest {
  @Test
  void whatFitsIsNotSaid() {
    assertThatCode(
            () -> {
              MemoryEstimator.ofTriangles(100);
              MemoryEstimator.ofPatches(100, 64, 100, "a mesh makes");
              MemoryEstimator.ofTexels(100);
            })
        .doesNotThrowAnyException();
  }

  @Test
  void whatDoesNotFitIsSaidWithWhatToDo() {
    long more = Runtime.getRuntime().maxMemory();
    assertThatThrownBy(() -> MemoryEstimator.ofTriangles(Integer.MAX_VALUE))
        .isInstanceOf(RadiosityException.class)
        .hasMessageStartingWith("lighting 2147483647 triangles takes about 1433600 MB of memory")
        .hasMessageEndingWith("; give Java more with SELECTIVE_RENDERER_JAVA_OPTS=-Xmx4g");
    assertThatThrownBy(() -> MemoryEstimator.ofPatches(more, 64, 1, "a mesh makes"))
        .isInstanceOf(RadiosityException.class)
        .hasMessageStartingWith("a mesh makes " + more + " patches and up to 1 polygons, which")
        .hasMessageContaining("raise --max-mesh, lower --max-polygons, or give Java more");
    assertThatThrownBy(() -> MemoryEstimator.ofTexels(more))
        .isInstanceOf(RadiosityException.class)
        .hasMessageContaining("lower --texture-budget, or give Java more");
  }
}
