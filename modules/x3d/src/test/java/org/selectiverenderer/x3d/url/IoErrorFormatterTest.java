package org.selectiverenderer.x3d.url;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import org.junit.jupiter.api.Test;

class IoErrorFormatterTest {
  @Test
  void whyAFileCannotBeReadDoesNotNameItsFolder() {
    String file = "/home/me/chairs.x3d";
    assertThat(IoErrorFormatter.clause(new AccessDeniedException(file)))
        .isEqualTo("cannot be read: no permission");
    assertThat(IoErrorFormatter.clause(new NoSuchFileException(file)))
        .isEqualTo("no longer exists");
    assertThat(IoErrorFormatter.clause(new FileSystemException(file))).isEqualTo("cannot be read");
    assertThat(IoErrorFormatter.clause(new FileSystemException(file, null, "Is a directory")))
        .isEqualTo("Is a directory");
    assertThat(IoErrorFormatter.clause(new IOException("the text is cut off")))
        .isEqualTo("the text is cut off");
  }
}
