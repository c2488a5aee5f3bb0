package org.selectiverenderer.render.context;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.opengl.JoglVersion;
import org.junit.jupiter.api.Test;

class GlInfoTest {
  /** In the jar there is no manifest of JOGL's, from which it would say the version itself. */
  @Test
  void theVersionOfJoglIsKnownWithoutItsManifest() {
    assertThat(GlInfo.libraryVersion())
        .isEqualTo(JoglVersion.getInstance().getImplementationVersion())
        .matches("\\d+(\\.\\d+)+.*");
  }
}
