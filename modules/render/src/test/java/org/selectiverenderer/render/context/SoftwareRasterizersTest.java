package org.selectiverenderer.render.context;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SoftwareRasterizersTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "llvmpipe (LLVM 15.0.6, 256 bits)",
        "softpipe",
        "Software Rasterizer",
        "Mesa X11",
        "Google SwiftShader",
        "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (LLVM 16.0.0)), SwiftShader driver)",
        "D3D12 (Microsoft Basic Render Driver)",
        "GDI Generic",
        "Apple Software Renderer",
        "zink Vulkan 1.3(llvmpipe (LLVM 15.0.6, 256 bits) (MESA_LLVMPIPE))"
      })
  void aProcessorThatDrawsIsKnownByItsName(String renderer) {
    assertThat(new GlInfo("", renderer, "").software()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "NVIDIA H200/PCIe/SSE2",
        "Mesa Intel(R) UHD Graphics 620 (KBL GT2)",
        "AMD Radeon RX 6600 (radeonsi, navi23, LLVM 15.0.6, DRM 3.49)",
        "Apple M2",
        "D3D12 (NVIDIA GeForce RTX 3060)",
        "unknown",
        ""
      })
  void aGraphicsCardIsNot(String renderer) {
    assertThat(new GlInfo("", renderer, "").software()).isFalse();
  }
}
