package org.selectiverenderer.testing;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A test that needs a display with OpenGL 3.3 core. Without one it is skipped and says why; where
 * the environment variable {@code SELECTIVE_RENDERER_REQUIRE_GL} is 1, as in CI, it fails instead,
 * so that a build without OpenGL cannot pass by skipping.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@ExtendWith(DisplayCondition.class)
public @interface RequiresDisplay {}
