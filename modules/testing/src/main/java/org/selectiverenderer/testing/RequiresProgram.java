package org.selectiverenderer.testing;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A test that runs another program, such as {@code Rscript}. Where that is not on the path the test
 * is skipped and says why; where its environment variable is 1 ({@code
 * SELECTIVE_RENDERER_REQUIRE_R} for R, {@code SELECTIVE_RENDERER_REQUIRE_BIDS} for the BIDS
 * validator) it fails instead, so that a build that lost the program cannot pass by skipping.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@ExtendWith(ProgramCondition.class)
public @interface RequiresProgram {
  /** The program's name, without a folder or an ending. */
  String value();
}
