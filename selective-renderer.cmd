@echo off
rem Builds the application when its jar is missing or older than the sources, then runs it.
rem
rem JAVA_HOME                      the Java to use; without it, the one on PATH
rem SELECTIVE_RENDERER_JAVA_OPTS   further flags for Java, such as -Xmx4g
rem SELECTIVE_RENDERER_SAI         another browser's jars in place of x3d-sai.jar: a folder of jars or
rem                                a class path, for example Xj3D's
setlocal
set "SR_HOME=%~dp0"
set "SR_JAR=%SR_HOME%target\selective-renderer.jar"

set "SR_JAVA=java.exe"
if defined JAVA_HOME set "SR_JAVA=%JAVA_HOME%\bin\java.exe"
rem No blocks in this file: a parenthesis in a folder's name, as in Program Files (x86), would end them.
if defined JAVA_HOME if not exist "%SR_JAVA%" goto badhome
if defined JAVA_HOME goto version
where java.exe >nul 2>&1
if errorlevel 1 goto nojava
:version
"%SR_JAVA%" --list-modules 2>nul | findstr /r /c:"^java.base@1[7-9]" /c:"^java.base@[2-9][0-9]" >nul
if errorlevel 1 goto oldjava

rem Folders count too: their time changes when a source is deleted.
powershell -NoProfile -ExecutionPolicy Bypass -Command ^
  "Set-Location -LiteralPath $env:SR_HOME;" ^
  "$jar = Get-Item -LiteralPath $env:SR_JAR, target\x3d-sai.jar -ErrorAction SilentlyContinue;" ^
  "if (@($jar).Count -lt 2) { exit 1 };" ^
  "$roots = 'pom.xml', 'src\main', 'src\sai', 'tools' | Where-Object { Test-Path $_ };" ^
  "$files = @(Get-Item $roots) + @(Get-ChildItem $roots -Recurse);" ^
  "if ($files | Where-Object { $_.LastWriteTimeUtc -gt $jar[0].LastWriteTimeUtc }) { exit 1 }"
if not errorlevel 1 goto start

where mvn >nul 2>&1
if errorlevel 1 goto nomaven
echo selective-renderer: building the application, which takes a minute the first time>&2
if not exist "%SR_HOME%target" mkdir "%SR_HOME%target"
pushd "%SR_HOME%"
call mvn -q -B -DskipTests -Dmaven.test.skip=true package >target\launcher-build.log 2>&1 <nul
if errorlevel 1 goto failed
popd

:start
rem The jar's manifest grants native access; the program itself sets what its libraries read.
set "SR_PATH=%SR_JAR%"
rem Another browser is for the command sai only.
set "SR_SAI="
if /i "%~1"=="sai" set "SR_SAI=%SELECTIVE_RENDERER_SAI%"
if /i "%~2"=="sai" set "SR_SAI=%SELECTIVE_RENDERER_SAI%"
set "SR_TOLD="
if /i "%~1"=="run" set "SR_TOLD=run"
if /i "%~1"=="simulate" set "SR_TOLD=simulate"
if defined SELECTIVE_RENDERER_SAI if defined SR_TOLD echo selective-renderer: %SR_TOLD% runs in the embedded browser; SELECTIVE_RENDERER_SAI is for the command sai>&2
if defined SR_SAI set "SR_PATH=%SELECTIVE_RENDERER_SAI%;%SR_JAR%"
if defined SR_SAI if exist "%SELECTIVE_RENDERER_SAI%\*" set "SR_PATH=%SELECTIVE_RENDERER_SAI%\*;%SR_JAR%"
set "SR_FLAGS=-XX:+IgnoreUnrecognizedVMOptions -XX:+DisplayVMOutputToStderr -Xlog:disable"
rem Those that load and then do little in Java: quick code and a small heap.
set "SR_LIGHT=-XX:TieredStopAtLevel=1 -XX:+UseSerialGC -Xms64m -Xmn32m"
if /i "%~1"=="run" set "SR_FLAGS=%SR_FLAGS% %SR_LIGHT%"
if /i "%~1"=="simulate" set "SR_FLAGS=%SR_FLAGS% %SR_LIGHT%"
if /i "%~1"=="validate" set "SR_FLAGS=%SR_FLAGS% %SR_LIGHT%"
if /i "%~1"=="doctor" set "SR_FLAGS=%SR_FLAGS% %SR_LIGHT%"
if /i "%~1"=="radiosity" set "SR_FLAGS=%SR_FLAGS% -Xmx1200m"
if /i "%~1"=="bench" set "SR_FLAGS=%SR_FLAGS% -Dselective-renderer.run-flags=%SR_LIGHT: =,%"
rem What is typed is in no block either: a file may be called room(1).x3d.
if defined SR_SAI goto startsai
"%SR_JAVA%" %SR_FLAGS% %SELECTIVE_RENDERER_JAVA_OPTS% -jar "%SR_JAR%" %*
exit /b %ERRORLEVEL%

:startsai
"%SR_JAVA%" %SR_FLAGS% %SELECTIVE_RENDERER_JAVA_OPTS% -cp "%SR_PATH%" org.selectiverenderer.cli.Main %*
exit /b %ERRORLEVEL%

:badhome
echo selective-renderer: JAVA_HOME has no bin\java.exe: "%JAVA_HOME%" >&2
exit /b 2

:nojava
echo selective-renderer: no Java found: install a JDK 17 or newer, or set JAVA_HOME>&2
exit /b 2

:oldjava
echo selective-renderer: needs Java 17 or newer; set JAVA_HOME>&2
exit /b 2

:failed
type target\launcher-build.log >&2
popd
echo selective-renderer: the build failed, as Maven says above>&2
exit /b 2

:nomaven
echo selective-renderer: the application is not built yet, which takes Maven: install Maven 3.8 or newer>&2
exit /b 2
