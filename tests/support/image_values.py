"""What the program image_values prints of image files."""
import struct
import subprocess


def read(program, files):
    """For each file the message of a refusal, or format, maxima and pixels."""
    output = subprocess.run([program, *files], check=True, capture_output=True).stdout
    results = []
    for _ in files:
        line, output = output.split(b"\n", 1)
        words = line.decode().split(" ")
        if words[0] == "refused":
            results.append(line.decode().split(" ", 1)[1])
            continue
        width, height, channels = int(words[0]), int(words[1]), int(words[7])
        count = width * height
        values = struct.unpack(f"={channels * count}f", output[:4 * channels * count])
        output = output[4 * channels * count:]
        pixels = [list(values[3 * i:3 * i + 3]) + ([values[3 * count + i]] if channels == 4 else []) for i in range(count)]
        results.append((width, height, words[2], [int(word) for word in words[3:7]], pixels))
    assert not output
    return results


def bits(values):
    return [struct.pack("f", value) for pixel in values for value in pixel]
