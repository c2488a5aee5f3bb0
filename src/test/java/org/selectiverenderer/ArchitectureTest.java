package org.selectiverenderer;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaAccess.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.name;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.conditions.ArchPredicates.are;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.domain.JavaPackage;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.junit.ArchTests;
import com.tngtech.archunit.lang.ArchRule;
import java.io.IOException;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.NullMarked;

/** Holds the code against ARCHITECTURE.md: its table of uses, its layers and its boundaries. */
@AnalyzeClasses(
    packages = {"org.selectiverenderer", "org.web3d.x3d.sai"},
    importOptions = DoNotIncludeTests.class)
class ArchitectureTest {
  private static final String OURS = "org.selectiverenderer..";
  private static final String SAI = "org.web3d.x3d.sai..";

  /** Public for a reason that no use by another package shows. */
  private static final Set<String> PUBLIC_ALL_THE_SAME =
      Set.of(
          "org.selectiverenderer.browser.sai.EmbeddedBrowserFactory", // named, not called
          "org.selectiverenderer.study.headlog.HeadLog", // handed on without its name
          "org.selectiverenderer.browser.navigation.MotionRequest", // what a motion source of
          // others gives
          // what tests of other packages measure and plug in
          "org.selectiverenderer.tracker.Orientation",
          "org.selectiverenderer.tracker.emulator.InterTrax2Emulator",
          "org.selectiverenderer.tracker.emulator.PseudoTerminal",
          "org.selectiverenderer.validation.report.SarifReportWriter");

  private static final String[] DISPLAY = {
    "java.awt..", "javax.swing..", "com.jogamp..", "jogamp.."
  };

  @ArchTest
  static void packagesUseWhatThePageSays(JavaClasses ours) throws IOException {
    ArchitecturePage page = ArchitecturePage.read();
    Set<String> undocumented =
        ours.stream()
            .filter(user -> !topLevel(user).equals(ArchitecturePage.SAI))
            .flatMap(user -> user.getDirectDependenciesFromSelf().stream())
            .filter(ArchitectureTest::isBetweenTopLevels)
            .filter(
                use -> !page.allows(topLevel(use.getOriginClass()), topLevel(use.getTargetClass())))
            .map(use -> use.getOriginClass().getName() + " uses " + use.getTargetClass().getName())
            .collect(Collectors.toCollection(TreeSet::new));
    assertThat(undocumented).as("uses that ARCHITECTURE.md does not name").isEmpty();
  }

  @ArchTest
  static void thePageNamesNoUseThatHasGone(JavaClasses ours) throws IOException {
    Map<String, Set<String>> real =
        ours.stream()
            .flatMap(user -> user.getDirectDependenciesFromSelf().stream())
            .filter(ArchitectureTest::isBetweenTopLevels)
            .collect(
                Collectors.groupingBy(
                    use -> topLevel(use.getOriginClass()),
                    Collectors.mapping(use -> topLevel(use.getTargetClass()), Collectors.toSet())));
    assertThat(ArchitecturePage.read().named())
        .allSatisfy(
            (user, named) ->
                assertThat(real.getOrDefault(user, Set.of())).as(user).containsAll(named));
  }

  /** Imports that only Javadoc needs are not in the byte code. */
  @ArchTest
  static void sourcesImportWhatThePageAllows(JavaClasses ours) throws IOException {
    ArchitecturePage page = ArchitecturePage.read();
    Set<String> found = new TreeSet<>();
    for (SourceImport use : SourceImport.all()) {
      String user = topLevel(use.user());
      String used = topLevel(use.used());
      if (!used.isEmpty() && !used.equals(user) && !page.allows(user, used)) {
        found.add(use.toString());
      }
    }
    assertThat(found).as("imports that ARCHITECTURE.md does not allow").isEmpty();
  }

  @ArchTest
  static void thePageNamesEveryPackageAndNoOther(JavaClasses ours) throws IOException {
    Set<String> found =
        ours.stream()
            .map(ArchitectureTest::topLevel)
            .filter(name -> !name.equals(ArchitecturePage.SAI))
            .collect(Collectors.toCollection(TreeSet::new));
    ArchitecturePage page = ArchitecturePage.read();
    assertThat(page.layered()).as("packages in the drawing").isEqualTo(found);
    assertThat(page.described()).as("packages in the table").isEqualTo(found);
  }

  @ArchTest
  static void theTableFollowsTheDrawing(JavaClasses ours) throws IOException {
    assertThat(ArchitecturePage.read().usesThatDoNotGoDown()).isEmpty();
  }

  @ArchTest
  static final ArchRule everyPackageIsFreeOfCycles =
      slices().matching("org.selectiverenderer.(**)").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule theStandardsInterfacesKnowNothingOfOurs =
      noClasses()
          .that()
          .resideInAPackage(SAI)
          .should()
          .dependOnClassesThat()
          .resideInAPackage(OURS);

  @ArchTest
  static final ArchRule theControllerRunsOnAnyBrowser =
      classes()
          .that()
          .resideInAPackage(of("control"))
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage(
              of("control"), of("schema"), of("sai"), SAI, "java..", "org.jspecify..");

  @ArchTest
  static final ArchRule openGlLivesInTheRenderer =
      onlyIn("runtime.render", "com.jogamp..", "jogamp..");

  @ArchTest
  static final ArchRule modelsAreReadAndReducedInOnePlace =
      onlyIn("polygon", "org.lwjgl.assimp..", "org.lwjgl.util..");

  @ArchTest
  static final ArchRule headsetsAreDrivenBehindOneDoor = onlyIn("openxr", "org.lwjgl.openxr..");

  /**
   * Models are read by LWJGL's libraries; the user's liblsl is called by the libffi in LWJGL, and
   * an OpenXR runtime by its loader.
   */
  @ArchTest
  static final ArchRule nativeMemoryIsTouchedBehindThreeDoors =
      noClasses()
          .that()
          .resideOutsideOfPackages(of("polygon"), of("lsl"), of("openxr"))
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.lwjgl..");

  @ArchTest
  static final ArchRule foreignFunctionsAreCalledInOnePlace =
      onlyIn("lsl", "org.lwjgl.system.libffi..");

  @ArchTest
  static final ArchRule soundIsReadAndPlayedInOnePlace = onlyIn("runtime.sound", "javax.sound..");

  @ArchTest
  static final ArchRule serialPortsAreOpenedInOnePlace = onlyIn("tracker.serial", "com.fazecast..");

  @ArchTest
  static final ArchRule tablesAreReadAndWrittenInOnePlace =
      onlyIn("base.csv", "org.apache.commons.csv..");

  @ArchTest
  static final ArchRule displaysAndLightNeedNoRenderer =
      noClasses()
          .that()
          .resideInAnyPackage(of("hmd"), of("radiosity"), of("runtime.camera"))
          .should()
          .dependOnClassesThat()
          .resideInAPackage(of("runtime.render"));

  @ArchTest
  static final ArchRule commandsAreChosenByTheEntryOnly =
      noClasses()
          .that()
          .resideInAPackage("org.selectiverenderer.cli.*..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.selectiverenderer.cli");

  @ArchTest
  static final ArchRule whatServersRunNeedsNoDisplay =
      noClasses()
          .that()
          .resideInAnyPackage(
              of("base"),
              of("x3d"),
              of("geometry"),
              of("chart"),
              of("schema"),
              of("polygon"),
              of("statistics"),
              of("tracker"),
              of("lsl"),
              of("document"),
              of("validation"),
              of("radiosity"),
              of("modelling"),
              of("apartment"))
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(DISPLAY);

  @ArchTest
  static final ArchRule rhinoHasTwoDoors =
      noClasses()
          .that(
              are(resideInAPackage(OURS))
                  .and(not(resideInAnyPackage(of("x3d.script"), of("runtime.script")))))
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.mozilla..");

  @ArchTest
  static final ArchRule sessionsAreKeptWithoutWindows =
      noClasses()
          .that(
              are(resideInAPackage(of("experiment")))
                  .and(not(resideInAPackage(of("experiment.window")))))
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(DISPLAY);

  @ArchTest
  static final ArchRule theApartmentsRecipesAreModellingOnly =
      noClasses()
          .that()
          .resideInAnyPackage(
              of("apartment.kitchen"),
              of("apartment.lounge"),
              of("apartment.office"),
              of("apartment.furniture"))
          .should()
          .dependOnClassesThat(
              are(resideInAPackage(OURS))
                  .and(
                      not(
                          resideInAnyPackage(
                              of("modelling"),
                              of("geometry"),
                              of("apartment.looks"),
                              of("apartment.pictures"),
                              of("apartment.kitchen"),
                              of("apartment.lounge"),
                              of("apartment.office"),
                              of("apartment.furniture")))));

  /** Generated files have the same bytes everywhere, which Math's functions do not promise. */
  @ArchTest
  static final ArchRule modelsAreMadeWithStrictMathematics =
      noClasses()
          .that()
          .resideInAnyPackage(of("modelling"), of("apartment"), of("radiosity"))
          .should()
          .callMethodWhere(
              target(owner(assignableTo(Math.class)))
                  .and(
                      target(
                          nameMatching(
                              "a?(sin|cos|tan)h?|atan2|exp|expm1|log|log10|log1p|pow|cbrt|hypot"))));

  @ArchTest
  static final ArchRule onlyTheCommandLineTouchesTheProcess =
      noClasses()
          .that()
          .resideOutsideOfPackage(of("cli"))
          .should()
          .accessField(System.class, "out")
          .orShould()
          .accessField(System.class, "err")
          .orShould()
          .callMethod(System.class, "exit", int.class)
          .orShould()
          .callMethod(Runtime.class, "exit", int.class)
          .orShould()
          .callMethod(Runtime.class, "halt", int.class);

  @ArchTest
  static final ArchRule nobodyPrintsAStackTraceToAUser =
      noClasses()
          .that()
          .doNotHaveSimpleName("FailureReport") // for --debug
          .should()
          .callMethodWhere(target(name("printStackTrace"))); // of whatever exception

  /** The standard's own BrowserFactory is exempt: a static setter is its specified interface. */
  @ArchTest
  static final ArchRule noStaticState =
      fields()
          .that()
          .areStatic()
          .and()
          .areDeclaredInClassesThat()
          .resideInAPackage(OURS)
          .should()
          .beFinal();

  /** A door that nobody outside goes through is a wall: such a type is package-private. */
  @ArchTest
  static void publicTypesAreUsedByOtherPackages(JavaClasses ours) {
    Stream<String> inside =
        ours.stream()
            .filter(found -> found.getName().startsWith("org.selectiverenderer."))
            .filter(JavaClass::isTopLevelClass)
            .filter(found -> found.getModifiers().contains(JavaModifier.PUBLIC))
            .filter(found -> !found.isInterface()) // a lambda of another package may be one
            .filter(found -> found.tryGetMethod("main", String[].class).isEmpty())
            .filter(found -> !isUsedFromOutside(found))
            .map(JavaClass::getName)
            .filter(found -> !PUBLIC_ALL_THE_SAME.contains(found));
    assertThat(inside).as("public types that no other package uses").isEmpty();
  }

  @ArchTest
  static void noNameStandsForTwoThings(JavaClasses ours) {
    Stream<String> twice =
        ours.stream()
            .filter(found -> found.getName().startsWith("org.selectiverenderer."))
            .filter(JavaClass::isTopLevelClass)
            .filter(found -> !found.getSimpleName().equals("package-info"))
            .collect(Collectors.groupingBy(JavaClass::getSimpleName))
            .entrySet()
            .stream()
            .filter(named -> named.getValue().size() > 1)
            .map(named -> named.getKey() + ": " + named.getValue());
    assertThat(twice).as("simple names of several classes").isEmpty();
  }

  @ArchTest
  static void everyPackageIsDescribedAndNullMarked(JavaClasses ours) {
    Stream<String> undescribed =
        ours.stream()
            .map(JavaClass::getPackage)
            .distinct()
            .filter(found -> !isNullMarked(found))
            .map(JavaPackage::getName);
    assertThat(undescribed).as("packages without a @NullMarked package-info").isEmpty();
  }

  @ArchTest static final ArchTests librariesAreWhole = ArchTests.in(LibraryRules.class);

  private static boolean isUsedFromOutside(JavaClass found) {
    return found.getDirectDependenciesToSelf().stream()
            .anyMatch(use -> !use.getOriginClass().getPackageName().equals(found.getPackageName()))
        || found.getAllSubclasses().stream().anyMatch(ArchitectureTest::isUsedFromOutside);
  }

  private static boolean isNullMarked(JavaPackage described) {
    return described
        .tryGetPackageInfo()
        .filter(info -> info.isAnnotatedWith(NullMarked.class))
        .isPresent();
  }

  private static boolean isBetweenTopLevels(Dependency use) {
    String user = topLevel(use.getOriginClass());
    String used = topLevel(use.getTargetClass());
    return !used.isEmpty() && !used.equals(user);
  }

  /** The name below {@code org.selectiverenderer}, or the SAI's, or empty for others' classes. */
  private static String topLevel(JavaClass type) {
    return topLevel(type.getPackageName());
  }

  private static String topLevel(String packageName) {
    if (packageName.startsWith("org.web3d.x3d.sai")) {
      return ArchitecturePage.SAI;
    }
    return packageName.startsWith("org.selectiverenderer.") ? packageName.split("\\.")[2] : "";
  }

  /** A package and what lies within, as ArchUnit writes it. */
  private static String of(String name) {
    return "org.selectiverenderer." + name + "..";
  }

  private static ArchRule onlyIn(String user, String... libraries) {
    return noClasses()
        .that()
        .resideOutsideOfPackage(of(user))
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(libraries);
  }
}
