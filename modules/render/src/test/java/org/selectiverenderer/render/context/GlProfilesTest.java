package org.selectiverenderer.render.context;

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
}
