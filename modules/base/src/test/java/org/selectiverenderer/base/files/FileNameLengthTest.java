package org.selectiverenderer.base.files;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class FileNameLengthTest {
  @Test
  void aNameThatFitsStays() {
    assertThat(FileNameLength.shortened("x".repeat(245), 10)).hasSize(245);
    assertThat(FileNameLength.shortened("x".repeat(246), 10)).hasSize(245);
  }

  @Test
  void charactersAreNotCut() {
    assertThat(FileNameLength.shortened("\u00e4".repeat(200), 0)).hasSize(127);
    assertThat(FileNameLength.shortened("\ud83d\ude00".repeat(100), 1)).hasSize(2 * 63);
  }
}
