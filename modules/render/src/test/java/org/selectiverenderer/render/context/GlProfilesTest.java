package org.selectiverenderer.render.context;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.jogamp.opengl.GLException;
import org.junit.jupiter.api.Test;

class GlProfilesTest {
  @Test
  void aDriverThatDoesNotBeginInTimeIsTold() {
    // What a lock of JOGL throws.
    RuntimeException waited =
        new RuntimeException("Waited 5000ms for: <1, 2>[count 1, owner <gl-start>] - <main>");

    assertThatThrownBy(
            () ->
                GlProfiles.begun(
                    () -> {
                      throw waited;
                    }))
        .isInstanceOf(GlUnavailableException.class)
        .hasMessageContaining("did not start in time")
        .hasMessageContaining("try again")
        .hasMessageNotContaining("lock")
        .hasCause(waited);
  }

  @Test
  void anyOtherFailureStaysWhatItIs() {
    GLException other = new GLException("no such profile");

    assertThatThrownBy(
            () ->
                GlProfiles.begun(
                    () -> {
                      throw other;
                    }))
        .isSameAs(other);
  }

  @Test
  void adviceFitsTheSystem() {
    assertThat(GlProfiles.tooOld("GL2", "Linux"))
        .startsWith("the display's driver has no OpenGL 3.3, only GL2: ")
        .contains("LIBGL_ALWAYS_SOFTWARE=1");
    assertThat(GlProfiles.tooOld("GL2", "Windows 11"))
        .contains("graphics card's maker")
        .doesNotContain("LIBGL");
    assertThat(GlProfiles.tooOld("GL2", "Mac OS X")).contains("macOS").doesNotContain("LIBGL");
  }
}
