package org.selectiverenderer.command.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Test;

class FailureMessageTest {
  @Test
  void workOfSeveralThreadsFailsByItsCause() {
    assertThat(FailureMessage.of(new CompletionException(new OutOfMemoryError("Java heap space"))))
        .startsWith("out of memory; ");
  }
}
