package org.selectiverenderer.enricher.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.api.parallel.Resources;

/** Names of steps, which the document gives in English. */
class UndoStepNamesTest {
  @Test
  @ResourceLock(Resources.LOCALE)
  void stepsOfTheDocumentHaveGreekNames() {
    Locale before = Locale.getDefault(Locale.Category.DISPLAY);
    Locale.setDefault(Locale.Category.DISPLAY, Locale.forLanguageTag("el"));
    try {
      UndoStepNames names = new UndoStepNames();
      assertThat(names.shown("Describe choice 1 of Sofa"))
          .isEqualTo("Περιγραφή της επιλογής 1: Sofa");
      assertThat(names.shown("Add an empty choice to Sofa"))
          .isEqualTo("Προσθήκη κενής επιλογής: Sofa");
      assertThat(names.shown("Rename {0} to Bed")).isEqualTo("Μετονομασία: {0} σε Bed");
      assertThat(names.shown("Add the quality textures to Sofa"))
          .isEqualTo("Προσθήκη της ποιότητας textures στο Sofa");
      assertThat(names.shown("Set level 1 of Sofa.url"))
          .isEqualTo("Τιμή της στάθμης 1 του Sofa.url");
      assertThat(names.shown("Typing")).isEqualTo("Πληκτρολόγηση");
      assertThat(names.shown("Επικόλληση")).isEqualTo("Επικόλληση");
    } finally {
      Locale.setDefault(Locale.Category.DISPLAY, before);
    }
  }

  @Test
  void inEnglishTheyStayAsTheyAre() {
    UndoStepNames names = new UndoStepNames();
    assertThat(names.shown("Set degree of Switch DEF='A'"))
        .isEqualTo("Set degree of Switch DEF='A'");
    assertThat(names.shown("Delete choice 12 of Sofa")).isEqualTo("Delete choice 12 of Sofa");
  }
}
