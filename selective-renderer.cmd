@echo off
rem Builds the application when its jar is missing or older than the sources, then runs it. In a package,
rem where a Java of its own and the jar lie beside it, it runs these.
rem
rem JAVA_HOME                      the Java to use; without it, the one on PATH
rem SELECTIVE_RENDERER_JAVA_OPTS   further flags for Java, such as -Xmx4g
rem SELECTIVE_RENDERER_SAI         another browser's jars in place of x3d-sai.jar: a folder of jars or
rem                                a class path, for example Xj3D's
rem
rem As selective-renderer, the script for other systems, but for four things: no archive of classes is made,
rem no build waits for another, no picture is shown before a window, and nothing is set that only Linux reads.
rem
rem No blocks in this file: a parenthesis in a folder's name, as in Program Files (x86), would end them.
setlocal
set "SR_HOME=%~dp0"
set "SR_STORE=%SR_HOME%target"
set "SR_PACKAGED="
if exist "%SR_HOME%runtime\bin\java.exe" set "SR_PACKAGED=yes"
if defined SR_PACKAGED set "SR_STORE=%SR_HOME%app"
set "SR_JAR=%SR_STORE%\selective-renderer.jar"

rem --- Java ---------------------------------------------------------------------------------------

if defined SR_PACKAGED goto packagedjava
if defined JAVA_HOME goto chosenjava
rem What is found on PATH, or nothing.
for %%J in (java.exe) do set "SR_JAVA=%%~$PATH:J"
for %%J in (java.exe) do set "SR_RELEASE=%%~dp$PATH:J..\release"
if not defined SR_JAVA goto nojava
goto version
:packagedjava
set "SR_JAVA=%SR_HOME%runtime\bin\java.exe"
set "SR_RELEASE=%SR_HOME%runtime\release"
goto version
:chosenjava
set "SR_JAVA=%JAVA_HOME%\bin\java.exe"
set "SR_RELEASE=%JAVA_HOME%\release"
if not exist "%SR_JAVA%" goto badhome

:version
call :isjava "1[7-9]" "[2-9][0-9]"
if errorlevel 1 goto oldjava
set "SR_FLAGS=-XX:+IgnoreUnrecognizedVMOptions -XX:+DisplayVMOutputToStderr -Xlog:disable"
set "SR_FLAGS=%SR_FLAGS% -Djoml.nounsafe=true"
if defined SR_PACKAGED set "SR_FLAGS=%SR_FLAGS% -Dselective-renderer.installed=true"
set "SR_GRANTS=--enable-native-access=ALL-UNNAMED --sun-misc-unsafe-memory-access=allow"
call :isjava "2[4-9]" "[3-9][0-9]"
if not errorlevel 1 set "SR_FLAGS=%SR_FLAGS% %SR_GRANTS%"

rem --- Build --------------------------------------------------------------------------------------

if defined SR_PACKAGED goto start
call :isfresh
if not errorlevel 1 goto start

where mvn >nul 2>&1
if errorlevel 1 goto nomaven
echo selective-renderer: building the application, which takes a minute the first time>&2
if not exist "%SR_HOME%target" mkdir "%SR_HOME%target"
pushd "%SR_HOME%"
call mvn -q -B -DskipTests -Dmaven.test.skip=true package >target\launcher-build.log 2>&1 <nul
if errorlevel 1 goto failed
popd
rem A source from the future would be built at every start.
call :isfresh
if errorlevel 1 powershell -NoProfile -ExecutionPolicy Bypass -Command ^
  "(Get-Item -LiteralPath $env:SR_JAR).LastWriteTimeUtc = [DateTime]::UtcNow"

rem --- Flags --------------------------------------------------------------------------------------

:start
set "SR_PATH=%SR_JAR%"
rem Another browser is for the command sai only.
set "SR_SAI="
if /i "%~1"=="sai" set "SR_SAI=%SELECTIVE_RENDERER_SAI%"
if /i "%~2"=="sai" set "SR_SAI=%SELECTIVE_RENDERER_SAI%"
set "SR_TOLD="
if /i "%~1"=="run" set "SR_TOLD=run"
if /i "%~1"=="simulate" set "SR_TOLD=simulate"
if /i "%~2"=="sai" set "SR_TOLD="
if defined SELECTIVE_RENDERER_SAI if defined SR_TOLD echo selective-renderer: %SR_TOLD% runs in the embedded browser; SELECTIVE_RENDERER_SAI is for the command sai>&2
if defined SR_SAI set "SR_PATH=%SELECTIVE_RENDERER_SAI%;%SR_JAR%"
if defined SR_SAI if exist "%SELECTIVE_RENDERER_SAI%\*" set "SR_PATH=%SELECTIVE_RENDERER_SAI%\*;%SR_JAR%"
rem Those that load and then do little in Java: quick code and a small heap.
set "SR_LIGHT=-XX:TieredStopAtLevel=1 -XX:+UseSerialGC -Xms64m -Xmn32m -XX:MinHeapFreeRatio=80 -XX:MaxHeapFreeRatio=90"
if /i "%~1"=="run" set "SR_FLAGS=%SR_FLAGS% %SR_LIGHT%"
if /i "%~1"=="simulate" set "SR_FLAGS=%SR_FLAGS% %SR_LIGHT%"
if /i "%~1"=="validate" set "SR_FLAGS=%SR_FLAGS% %SR_LIGHT%"
if /i "%~1"=="doctor" set "SR_FLAGS=%SR_FLAGS% %SR_LIGHT%"
if /i "%~1"=="radiosity" set "SR_FLAGS=%SR_FLAGS% -Xmx1200m"
if /i "%~1"=="start" set "SR_FLAGS=%SR_FLAGS% -Dselective-renderer.run-flags=%SR_LIGHT: =,%"
if /i "%~1"=="bench" set "SR_FLAGS=%SR_FLAGS% -Dselective-renderer.run-flags=%SR_LIGHT: =,%"
rem What is typed is in no block either: a file may be called room(1).x3d.
"%SR_JAVA%" %SR_FLAGS% %SELECTIVE_RENDERER_JAVA_OPTS% -cp "%SR_PATH%" org.selectiverenderer.cli.Main %*
exit /b %ERRORLEVEL%

rem --- What is asked twice ------------------------------------------------------------------------

rem Error level 0 where the number of Java's version is one of two patterns. Read from the JDK's file, since
rem to start Java for it costs as much as a command; a Java of PATH may be a copy without that file.
:isjava
if not exist "%SR_RELEASE%" goto askjava
findstr /r /c:"^JAVA_VERSION=.%~1" /c:"^JAVA_VERSION=.%~2" "%SR_RELEASE%" >nul
exit /b %ERRORLEVEL%
:askjava
"%SR_JAVA%" --list-modules 2>nul | findstr /r /c:"^java.base@%~1" /c:"^java.base@%~2" >nul
exit /b %ERRORLEVEL%

rem Error level 0 where the jars are there and no source is newer. A release's jars, which packaging/validate
rem has downloaded, are as new as its note of that. Folders count too: their time changes when a source is
rem deleted.
:isfresh
powershell -NoProfile -ExecutionPolicy Bypass -Command ^
  "Set-Location -LiteralPath $env:SR_HOME;" ^
  "$jar = Get-Item -LiteralPath $env:SR_JAR, target\x3d-sai.jar -ErrorAction SilentlyContinue;" ^
  "if (@($jar).Count -lt 2) { exit 1 };" ^
  "$made = $jar[0].LastWriteTimeUtc;" ^
  "$note = Get-Item -LiteralPath target\downloaded -ErrorAction SilentlyContinue;" ^
  "if ($note -and $note.LastWriteTimeUtc -gt $made) { $made = $note.LastWriteTimeUtc };" ^
  "$roots = 'pom.xml', 'src\pom.xml', 'src\main', 'modules\*\pom.xml', 'modules\*\src\main'," ^
  "'tools\*\pom.xml', 'tools\*\src\main' | Get-Item -ErrorAction SilentlyContinue;" ^
  "$files = @($roots) + @($roots | Where-Object PSIsContainer | Get-ChildItem -Recurse);" ^
  "if ($files | Where-Object { $_.LastWriteTimeUtc -gt $made }) { exit 1 }"
exit /b %ERRORLEVEL%

rem --- What is lacking ----------------------------------------------------------------------------

:badhome
echo selective-renderer: JAVA_HOME has no bin\java.exe: "%JAVA_HOME%" >&2
exit /b 2

:nojava
echo selective-renderer: no Java found: install a JDK 17 or newer, or set JAVA_HOME>&2
exit /b 2

:oldjava
echo selective-renderer: needs Java 17 or newer, which this one is not: "%SR_JAVA%"; set JAVA_HOME>&2
exit /b 2

:failed
type target\launcher-build.log >&2
popd
echo selective-renderer: the build failed, as Maven says above>&2
exit /b 2

:nomaven
echo selective-renderer: the application is not built yet, which takes Maven: install Maven 3.8 or newer>&2
exit /b 2
