package org.selectiverenderer.app.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.FutureTask;
import javax.swing.JButton;
import javax.swing.JFrame;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.GuiRobot;

/** The form before a session. */
@ShowsWindows
class FormWindowTest extends SessionWindowFixture {
  @Test
  void theFormGoesOnWithAnAgeAndConsentOnly() throws IOException {
    LoadedStudy material = form("en");
    List<String> heard = new CopyOnWriteArrayList<>();
    FutureTask<Boolean> asked = asking(material, material.form(), true, heard);
    JFrame form = WindowFinder.named(hands, "questionnaire");
    JButton begin = GuiRobot.named(form, "Begin", JButton.class);
    choose(form, "Age: 28-32", heard);
    assertThat(GuiRobot.onEdt(begin::isEnabled)).isFalse();
    String consent = material.form().questions().get(0).text();
    choose(form, consent + ": No", heard);
    assertThat(GuiRobot.onEdt(begin::isEnabled)).as("who does not consent").isFalse();
    pictures(form, "session-form-refused");
    choose(form, consent + ": Yes", heard);
    hands.await("Begin", begin::isEnabled);
    pictures(form, "session-form");
    WindowFinder.click(hands, begin, () -> !form.isShowing());
    assertThat(WindowFinder.answer(asked)).isTrue();
    assertThat(heard).containsExactly("age 28-32", "consent no", "consent yes");
    assertThat(places).containsExactly(2, 1, 1);
  }

  @Test
  void theTemplatesConsentStandsOnAPageOfItsOwnAndMustBeGivenInFull() throws IOException {
    LoadedStudy material = material("en");
    FutureTask<Boolean> asked = asking(material, material.form(), true, new ArrayList<>());
    JFrame form = WindowFinder.named(hands, "questionnaire");
    assertThat(pages).hasSize(1);
    assertThat(GuiRobot.onEdt(GuiRobot.named(form, "Continue", JButton.class)::isEnabled))
        .isFalse();
    pictures(form, "session-consent");
    assertThat(asked.isDone()).isFalse();
  }

  @Test
  void theFormSaysWhoDoesNotTakePart() throws IOException {
    LoadedStudy material = form("el");
    FutureTask<Boolean> asked = asking(material, material.form(), true, new ArrayList<>());
    JFrame form = WindowFinder.named(hands, "questionnaire");
    pictures(form, "session-form-greek");
    JButton cancel = GuiRobot.named(form, material.wording().of("form.cancel"), JButton.class);
    WindowFinder.click(hands, cancel, () -> !form.isShowing());
    assertThat(WindowFinder.answer(asked)).isFalse();
  }

  @Test
  void closingTheFormAsksAndTheFormGoesWithTheSessionOnly() throws IOException {
    LoadedStudy material = form("en");
    FutureTask<Boolean> asked = asking(material, material.form(), true, new ArrayList<>());
    JFrame form = WindowFinder.named(hands, "questionnaire");
    WindowFinder.close(form);
    hands.await("the question", () -> closings.get() == 1);
    assertThat(GuiRobot.onEdt(form::isShowing)).isTrue();
    assertThat(asked.isDone()).isFalse();
    over.set(true);
    assertThat(WindowFinder.answer(asked)).isFalse();
    hands.await("the form to go", () -> !form.isShowing());
  }
}
