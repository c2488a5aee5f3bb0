package org.selectiverenderer.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLOffscreenAutoDrawable;
import com.jogamp.opengl.GLProfile;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class DisplayConditionTest {
  @Test
  void withoutADisplayATestIsSkippedWithTheReason() {
    var result = DisplayCondition.decide(Optional.of("no display"), false);
    assertThat(result.isDisabled()).isTrue();
    assertThat(result.getReason()).hasValue("no display");
  }

  @Test
  void whereOpenGlIsRequiredItFailsInstead() {
    assertThatThrownBy(() -> DisplayCondition.decide(Optional.of("no display"), true))
        .hasMessageContaining("no display");
  }

  @Test
  void withEverythingThereItRuns() {
    assertThat(DisplayCondition.decide(Optional.empty(), true).isDisabled()).isFalse();
  }

  @Test
  @RequiresDisplay
  void whatItPromisesIsThere() {
    GLProfile profile = GLProfile.get(GLProfile.GL3);
    GLCapabilities capabilities = new GLCapabilities(profile);
    capabilities.setOnscreen(false);
    capabilities.setFBO(true);
    GLOffscreenAutoDrawable drawable =
        GLDrawableFactory.getFactory(profile)
            .createOffscreenAutoDrawable(null, capabilities, null, 16, 16);
    try {
      drawable.display();
      drawable.getContext().makeCurrent();
      assertThat(drawable.getGL().glGetString(GL.GL_VERSION)).isNotEmpty();
      drawable.getContext().release();
    } finally {
      drawable.destroy();
    }
  }
}
